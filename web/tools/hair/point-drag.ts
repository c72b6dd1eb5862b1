import type { PointerSample, Vec3 } from '../../view/types';
import { add, scaled, subtract } from '../geometry';
import { quantised } from '../stroke/polyline';
import { clickSlop, distance } from '../tool';
import { replacePart } from './edits';
import type { HairEdit, HairHost, HairScene } from './host';
import { places } from './measures';
import { mainPart, type Part, type Primitive, pointsOf, primitiveAt } from './style';

/** Neighbours on either side that follow a dragged control point, less and less. */
const FOLLOWERS = 3;

/** One grab of a control point; its neighbours follow softly, and a point on the head stays on it. */
export class PointDrag {
  readonly #primitive: Primitive;
  readonly #line: readonly Vec3[];
  readonly #start: PointerSample;
  #moved = false;
  #latest: HairEdit | null = null;

  constructor(
    private readonly host: HairHost,
    private readonly scene: HairScene,
    private readonly grip: { readonly index: number; readonly part: Part; readonly point: number },
    sample: PointerSample,
  ) {
    this.#primitive = primitiveAt(scene.step, grip.index)!;
    this.#line = pointsOf(this.#primitive, grip.part);
    this.#start = sample;
  }

  move(samples: readonly PointerSample[]): void {
    const sample = samples.at(-1);
    if (!sample) return;
    this.#moved ||= distance(sample, this.#start) > clickSlop(sample.pointerType);
    if (!this.#moved) return;
    const { index, part } = this.grip;
    const points = quantised(this.#dragged(sample), places(this.scene.height));
    if (points.length < 2) return;
    this.#latest = replacePart(this.scene, index, part, points);
    this.host.preview(this.#latest);
  }

  finish(sample: PointerSample): void {
    this.move([sample]);
    if (this.#latest) this.host.commit('move-point', this.#latest);
  }

  cancel(): void {
    this.host.cancel();
  }

  #dragged(sample: PointerSample): Vec3[] {
    const { part, point } = this.grip;
    const held = this.#line[point]!;
    const to = this.#onSkin(sample) ?? this.host.view.pointOnScreenPlane(sample.x, sample.y, held);
    const by = subtract(to, held);
    // A ring goes as a whole: its middle and radius are what counts.
    if (part === 'section') return this.#line.map((each) => add(each, by));
    return this.#line.map((each, i) => add(each, scaled(by, this.#share(i))));
  }

  #share(i: number): number {
    const { point } = this.grip;
    if (i === point) return 1;
    // The root holds its place on the head unless it is the one that is taken.
    if (i === 0 && this.#isRooted) return 0;
    const off = Math.abs(i - point) / (FOLLOWERS + 1);
    return off >= 1 ? 0 : (1 - off * off) ** 2;
  }

  #onSkin({ hit }: PointerSample): Vec3 | null {
    const onSkin = this.#primitive.kind === 'parting' || (this.grip.point === 0 && this.#isRooted);
    return onSkin && hit ? hit.point : null;
  }

  get #isRooted(): boolean {
    return this.#primitive.kind !== 'parting' && this.grip.part === mainPart(this.#primitive);
  }
}
