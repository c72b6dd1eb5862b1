import type { PointerSample } from '../../view/types';
import type { Tool } from '../tool';
import { linkAt } from './edits';
import type { CurvesHost } from './host';
import { gripAt } from './pose-tool';

/** Two clicks on control points: the first curve hangs on the second. Elsewhere the camera turns. */
export class LinkTool implements Tool {
  constructor(private readonly host: CurvesHost) {}

  down(sample: PointerSample): boolean {
    const scene = this.host.scene();
    if (!scene || sample.button !== 0) return false;
    const grip = gripAt(this.host, scene, sample);
    if (!grip || grip.point === null) return false;
    const { selected, step } = scene;
    if (!selected || selected.point === null || selected.curve === grip.curve) {
      this.host.select(grip);
      return true;
    }
    const linked = linkAt(step, selected, grip);
    if (linked === step) this.host.say('ring');
    else this.host.commit('link', { step: linked, selected: { curve: selected.curve, point: null } });
    return true;
  }

  move(): void {}

  up(): void {}

  hover(sample: PointerSample): void {
    const scene = this.host.scene();
    const grip = scene && gripAt(this.host, scene, sample);
    this.host.hover(grip?.point === null ? null : grip);
  }

  leave(): void {
    this.host.hover(null);
  }

  cancel(): void {}
}
