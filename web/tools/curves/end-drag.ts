import { pointsOf } from '../../recipe/steps/curves-edits';
import type { PointerSample } from '../../view/types';
import type { Drag } from '../drag-tool';
import { IDENTITY, transform } from '../geometry';
import { clickSlop, distance } from '../tool';
import { moveEnd } from './edits';
import type { CurvesHost, CurvesScene } from './host';
import type { Grip } from './items';
import { splineAt, splinePoints } from './spline';

/** How far an end goes at most in one drag, in parts of the curve: inwards, and straight on outwards. */
const INWARDS = 0.9;
const OUTWARDS = 0.6;
/** Places tried on the way. */
const TRIED = 150;

/** The end of a curve under a drag: it slides along the curve, or straight on beyond it. */
export class EndDrag implements Drag {
  readonly #end: 'start' | 'end';
  #by = 0;

  constructor(
    private readonly host: CurvesHost,
    private readonly scene: CurvesScene,
    private readonly grip: Grip,
    private readonly start: PointerSample,
  ) {
    this.#end = grip.point === 0 ? 'start' : 'end';
  }

  move(samples: readonly PointerSample[]): void {
    const sample = samples.at(-1);
    if (!sample) return;
    if (this.#by === 0 && distance(sample, this.start) <= clickSlop(sample.pointerType)) return;
    this.#by = this.#nearest(sample);
    const curve = this.#moved()?.curves[this.grip.curve];
    this.host.showStroke(curve ? splinePoints(pointsOf(curve), curve.rigid).map(this.#shown) : null);
  }

  finish(sample: PointerSample): void {
    this.move([sample]);
    this.host.showStroke(null);
    const step = this.#moved();
    if (step) this.host.commit('end', { step, selected: { curve: this.grip.curve, point: null } });
    else this.host.select(this.grip);
  }

  cancel(): void {
    this.host.showStroke(null);
    this.host.cancel();
  }

  readonly #shown = (point: Parameters<typeof transform>[1]) =>
    transform(this.scene.parents[this.grip.curve] ?? IDENTITY, point);

  #moved() {
    const { step, size } = this.scene;
    return this.#by === 0 ? null : moveEnd(step, this.grip.curve, this.#end, this.#by, size);
  }

  /** Which place on the curve, or straight on, is nearest to the pointer on screen. */
  #nearest({ x, y }: PointerSample): number {
    const points = pointsOf(this.scene.step.curves[this.grip.curve]!);
    let [best, least] = [0, Infinity];
    for (let k = 0; k <= TRIED; k++) {
      const by = -OUTWARDS + ((INWARDS + OUTWARDS) * k) / TRIED;
      const at = this.host.view.project(this.#shown(splineAt(points, this.#end === 'start' ? by : 1 - by)));
      const off = Math.hypot(at.x - x, at.y - y);
      if (!at.behind && off < least) [best, least] = [by, off];
    }
    return best;
  }
}
