import { pointsOf } from '../../recipe/steps/curves-edits';
import type { PointerSample, Vec3 } from '../../view/types';
import { type Drag, DragTool } from '../drag-tool';
import { IDENTITY, invert, subtract, transform } from '../geometry';
import { clickSlop, distance } from '../tool';
import { jointOf, moveCurve, movePoint, withPoints } from './edits';
import { EndDrag } from './end-drag';
import { GuardedEdit } from './guarded-edit';
import type { CurvesHost, CurvesScene } from './host';
import type { Grip } from './items';

/** Click selects a curve or a control point, drag moves it in the plane of the screen; elsewhere the camera turns. */
export class PoseTool extends DragTool {
  constructor(private readonly host: CurvesHost) {
    super();
  }

  protected override take(sample: PointerSample): Drag | null {
    const scene = this.host.scene();
    if (!scene || sample.button !== 0) return null;
    const grip = this.#under(scene, sample);
    if (!grip) return null;
    return this.host.slides()
      ? new EndDrag(this.host, scene, grip, sample)
      : new PointDrag(this.host, scene, grip, sample);
  }

  override hover(sample: PointerSample): void {
    const scene = this.host.scene();
    this.host.hover(scene && this.#under(scene, sample));
  }

  /** What a press would take hold of. */
  #under(scene: CurvesScene, sample: PointerSample): Grip | null {
    const grip = gripAt(this.host, scene, sample);
    if (!grip || !this.host.slides()) return grip;
    const last = scene.step.curves[grip.curve]!.rest.length - 1;
    return grip.point === 0 || grip.point === last ? grip : null;
  }

  override leave(): void {
    this.host.hover(null);
  }
}

/** What lies under the pointer. A line between points stands for the curve. */
export function gripAt(host: CurvesHost, { step }: CurvesScene, { x, y }: PointerSample): Grip | null {
  const hit = host.lines.pickLine(x, y);
  if (!hit) return null;
  const curve = step.curves.findIndex(({ id }) => id === hit.id);
  return curve < 0 ? null : { curve, point: hit.point };
}

/** One grab, from press to release. */
class PointDrag implements Drag {
  readonly #edit: GuardedEdit;
  readonly #grip: Grip;
  readonly #held: Vec3;
  #moved = false;

  constructor(
    private readonly host: CurvesHost,
    private readonly scene: CurvesScene,
    private readonly clicked: Grip,
    private readonly start: PointerSample,
  ) {
    const { step, parents } = scene;
    // A curve begins where its parent's point is: whoever drags the one means the other.
    const joint = clicked.point === 0 ? jointOf(step, clicked.curve) : null;
    this.#grip = joint ?? clicked;
    const { curve, point } = this.#grip;
    this.#held = transform(parents[curve] ?? IDENTITY, pointsOf(step.curves[curve]!)[point ?? 0]!);
    this.#edit = new GuardedEdit(host, step, this.#grip);
  }

  move(samples: readonly PointerSample[]): void {
    const sample = samples.at(-1);
    if (!sample) return;
    this.#moved ||= distance(sample, this.start) > clickSlop(sample.pointerType);
    if (!this.#moved) return;
    const { step, parents, size } = this.scene;
    const { curve, point } = this.#grip;
    const inverse = invert(parents[curve] ?? IDENTITY);
    if (!inverse) return;
    const { view } = this.host;
    // From where the pointer took hold: the grip keeps its place under it.
    const grabbed = view.pointOnScreenPlane(this.start.x, this.start.y, this.#held);
    const by = subtract(view.pointOnScreenPlane(sample.x, sample.y, this.#held), grabbed);
    const to = transform(inverse, [this.#held[0] + by[0], this.#held[1] + by[1], this.#held[2] + by[2]]);
    if (point === null) {
      const from = pointsOf(step.curves[curve]!)[0]!;
      this.#edit.offer(() => moveCurve(step, curve, subtract(to, from), size));
    } else if (this.host.reaches() !== sample.alt) this.#edit.offer(() => this.#reach(to));
    else this.#edit.offer(() => movePoint(step, this.#grip, to, size));
  }

  finish(sample: PointerSample): void {
    if (this.#moved) this.move([sample]);
    if (this.#moved) this.#edit.finish(this.host.reaches() !== sample.alt ? 'reach' : 'move');
    else this.host.select(this.clicked);
  }

  cancel(): void {
    this.#edit.cancel();
  }

  async #reach(to: Vec3) {
    const { step, anchors, size } = this.scene;
    const { curve: at, point } = this.#grip;
    const curve = step.curves[at]!;
    const held = anchors[at] === 'end' ? curve.rest.length - 1 : 0;
    if (point === held || point === null) return movePoint(step, this.#grip, to, size);
    return withPoints(step, curve, await this.host.reach(pointsOf(curve), point, to, [held]), size);
  }
}
