import type { PointerSample } from '../../view/types';
import type { Tool } from '../tool';
import { addPrimitive, isTooShort, kept } from './edits';
import type { HairHost, HairScene } from './host';
import { SPACING } from './measures';
import { HeadStroke } from './stroke';

/** Draws stream curves: a stroke that begins on the head. The hair follows while it is drawn. */
export class StreamTool implements Tool {
  readonly id = 'stream';
  #drawing: { readonly scene: HairScene; readonly stroke: HeadStroke } | null = null;

  constructor(private readonly host: HairHost) {}

  down(sample: PointerSample): boolean {
    const scene = this.host.scene();
    if (!scene || sample.button !== 0 || !sample.hit) return false;
    this.#drawing = { scene, stroke: new HeadStroke(this.host.view) };
    this.move([sample]);
    return true;
  }

  move(samples: readonly PointerSample[]): void {
    const drawing = this.#drawing;
    if (!drawing) return;
    drawing.stroke.extend(samples);
    this.host.showStroke({ line: drawing.stroke.line, kind: 'stream' });
    const edit = edited(drawing);
    if (edit) this.host.preview(edit);
  }

  up(sample: PointerSample): void {
    const drawing = this.#drawing;
    if (!drawing) return;
    drawing.stroke.extend([sample]);
    this.#drawing = null;
    this.host.showStroke(null);
    const edit = edited(drawing);
    if (edit) {
      this.host.rebuildSupport();
      this.host.commit('add-stream', edit);
      return;
    }
    this.host.cancel();
    this.host.say('too-short');
  }

  hover(sample: PointerSample): void {
    this.host.aim(sample.hit !== null);
  }

  leave(): void {
    this.host.aim(true);
  }

  cancel(): void {
    this.#drawing = null;
    this.host.showStroke(null);
    this.host.cancel();
  }
}

function edited({ scene, stroke }: { readonly scene: HairScene; readonly stroke: HeadStroke }) {
  if (isTooShort(stroke.line, scene.height)) return null;
  const points = kept(stroke.line, scene.height, SPACING);
  return points.length < 2 ? null : addPrimitive(scene, { kind: 'stream', item: { points, fade: false } });
}
