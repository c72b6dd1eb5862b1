import type { PointerSample } from '../../view/types';
import { applyHint, readHint } from '../stroke/hint';
import { quantised, thinned } from '../stroke/polyline';
import { onScreen, SupportStroke } from '../stroke/stroke';
import type { SupportSurface } from '../stroke/support';
import { evened, isTooShort, replacePart } from './edits';
import type { HairEdit, HairHost, HairRemark, HairScene } from './host';
import { nearness, places, SPACING } from './measures';
import { mainPart, pointsOf, primitiveAt } from './style';

/** One hint stroke beside the selected curve: cuts it, continues it or replaces a piece of it. */
export class HintGesture {
  readonly #stroke: SupportStroke;
  readonly #near: number;

  constructor(
    private readonly host: HairHost,
    private readonly scene: HairScene,
    private readonly index: number,
    support: SupportSurface,
    sample: PointerSample,
  ) {
    this.#stroke = new SupportStroke(host.view, support);
    this.#near = nearness(sample.pointerType);
    this.#stroke.extend([sample]);
  }

  move(samples: readonly PointerSample[]): void {
    this.#stroke.extend(samples);
    this.host.showStroke({ line: this.#stroke.line, kind: 'hint' });
    const { label, edit } = this.#read();
    // A stroke under way may yet become something else: a cut is only made when it is let go.
    if (edit && label !== 'cut') this.host.preview(edit);
    else this.host.cancel();
  }

  /** @param click  what a press without a stroke means */
  finish(sample: PointerSample, click: () => void): void {
    this.#stroke.extend([sample]);
    this.host.showStroke(null);
    const { label, edit, remark } = this.#read();
    if (label && edit) {
      this.host.commit(label, edit);
      return;
    }
    this.host.cancel();
    if (this.#stroke.line.length <= 2) click();
    else if (remark) this.host.say(remark);
  }

  #read(): {
    readonly label?: 'cut' | 'concatenate' | 'insert';
    readonly edit?: HairEdit;
    readonly remark?: HairRemark;
  } {
    const { step, height } = this.scene;
    const primitive = primitiveAt(step, this.index)!;
    const part = mainPart(primitive);
    const curve = pointsOf(primitive, part);
    const hint = readHint(onScreen(this.host.view, curve), this.#stroke.seen, this.#near);
    if (!hint) return { remark: 'not-a-hint' };
    // The curve's own points stay as they are: editing it often does not wear it down.
    const line = applyHint(curve, hint, evened(this.#stroke.line, height, SPACING));
    if (isTooShort(line, height)) return { remark: 'nothing-left' };
    const points = quantised(thinned(line, 0.4 * SPACING * height), places(height));
    return { label: hint.kind, edit: replacePart(this.scene, this.index, part, points) };
  }
}
