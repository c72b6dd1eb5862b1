import type { PointerSample, Vec3 } from '../../view/types';
import type { Tool } from '../tool';
import { addPrimitive, isTooShort, kept } from './edits';
import type { HairHost, HairScene } from './host';
import { nearness, PARTING_SPACING } from './measures';
import { nearestOn } from './polyline';
import { HeadStroke, onScreen } from './stroke';
import { primitiveAt } from './style';
import { TiltGesture } from './tilt';

/** What a dividing curve starts with (Fu Fig 4.4): lengths in grid steps. */
export const PARTING = { tilt: [0, 0] as [number, number], sigma: 1, height: 0.5 };

/**
 * Draws partings: a stroke on the skin. One that begins on the selected parting and leads away to a side
 * shows how the hair leans there.
 */
export class PartingTool implements Tool {
  readonly id = 'parting';
  #drawing: { readonly scene: HairScene; readonly stroke: HeadStroke } | null = null;
  #tilting: TiltGesture | null = null;

  constructor(private readonly host: HairHost) {}

  down(sample: PointerSample): boolean {
    const scene = this.host.scene();
    if (!scene || sample.button !== 0 || !sample.hit) return false;
    if (isNearSelected(this.host, scene, sample))
      this.#tilting = new TiltGesture(this.host, scene, scene.selected!, sample);
    else {
      this.#drawing = { scene, stroke: new HeadStroke(this.host.view) };
      this.move([sample]);
    }
    return true;
  }

  move(samples: readonly PointerSample[]): void {
    this.#tilting?.move(samples);
    const drawing = this.#drawing;
    if (!drawing) return;
    drawing.stroke.extend(samples);
    this.host.showStroke({ line: drawing.stroke.line, kind: 'parting' });
    const edit = edited(drawing);
    if (edit) this.host.preview(edit);
  }

  up(sample: PointerSample): void {
    this.#tilting?.finish(sample);
    this.#tilting = null;
    const drawing = this.#drawing;
    if (!drawing) return;
    drawing.stroke.extend([sample]);
    this.#drawing = null;
    this.host.showStroke(null);
    const edit = edited(drawing);
    if (edit) {
      this.host.commit('add-parting', edit);
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
    this.#tilting = null;
    this.host.showStroke(null);
    this.host.cancel();
  }
}

/** Only what lies on the skin before the stroke first leaves it. */
function edited({ scene, stroke }: { readonly scene: HairScene; readonly stroke: HeadStroke }) {
  const line = stroke.line.slice(0, stroke.onHead);
  if (isTooShort(line, scene.height)) return null;
  const points = kept(line, scene.height, PARTING_SPACING);
  return points.length < 2 ? null : addPrimitive(scene, { kind: 'parting', item: { points, ...PARTING } });
}

function isNearSelected(host: HairHost, { step, selected }: HairScene, sample: PointerSample): boolean {
  const primitive = primitiveAt(step, selected);
  if (primitive?.kind !== 'parting') return false;
  const at: Vec3 = [sample.x, sample.y, 0];
  const found = nearestOn(onScreen(host.view, primitive.item.points), at);
  return found !== undefined && found.distance <= nearness(sample.pointerType);
}
