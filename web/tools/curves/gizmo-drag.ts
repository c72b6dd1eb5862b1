import { type Quaternion, quaternionOf } from '../../core/quaternion';
import { pointsOf } from '../../recipe/steps/curves-edits';
import type { GizmoEvents, Vec3 } from '../../view/types';
import {
  anyNormal,
  cross,
  IDENTITY,
  invert,
  type Mat4,
  multiply,
  position,
  rotationOf,
  transform,
} from '../geometry';
import { aboutAxis, influence, moveCurve, movePoint, setScale, turnFrom, twistBy } from './edits';
import { GuardedEdit } from './guarded-edit';
import type { CurvesHost, CurvesLabel, CurvesScene } from './host';
import type { Grip } from './items';
import { tangentAt } from './spline';

/** What dragging a control point does, by the gizmo on it but for `end`, which has none: the point slides along its curve. */
export type CurveGizmo = Extract<CurvesLabel, 'move' | 'turn' | 'twist' | 'scale' | 'end'>;

/** Where the gizmo stands: on the control point, its third axis along the curve. Of a whole curve on the end that stays. */
export function gizmoFrame({ step, parents, anchors }: CurvesScene, { curve: at, point }: Grip): Mat4 | null {
  const curve = step.curves[at];
  if (!curve) return null;
  const points = pointsOf(curve);
  const on = point ?? (anchors[at] === 'end' ? points.length - 1 : 0);
  const place = points[on];
  if (!place) return null;
  const z = tangentAt(points, on);
  const x = anyNormal(z);
  const y = cross(z, x);
  const own: Mat4 = [...x, 0, ...y, 0, ...z, 0, ...place, 1];
  return multiply(parents[at] ?? IDENTITY, own);
}

/** One drag of the gizmo after another. */
export class CurveGizmoDrag implements GizmoEvents {
  #grip: { readonly scene: CurvesScene; readonly grip: Grip; readonly frame: Mat4 } | null = null;
  #edit: GuardedEdit | null = null;

  constructor(
    private readonly host: CurvesHost,
    private readonly mode: () => CurveGizmo,
  ) {}

  onStart = (): void => {
    const scene = this.host.scene();
    const grip = scene?.selected;
    const frame = scene && grip && gizmoFrame(scene, grip);
    this.#grip = frame ? { scene: scene!, grip: grip!, frame } : null;
    this.#edit = null;
  };

  onChange = (matrix: Mat4): void => {
    if (!this.#grip) return;
    const { scene, grip, frame } = this.#grip;
    const parent = scene.parents[grip.curve] ?? IDENTITY;
    const toOwn = invert(parent);
    const undo = invert(frame);
    if (!toOwn || !undo) return;
    const { step, size } = scene;
    this.#edit ??= new GuardedEdit(this.host, step, grip);
    const anchor = scene.anchors[grip.curve] ?? 'start';
    switch (this.mode()) {
      case 'move': {
        const to = transform(toOwn, position(matrix));
        const from = transform(toOwn, position(frame));
        const by: Vec3 = [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
        this.#edit.offer(() =>
          grip.point === null ? moveCurve(step, grip.curve, by, size) : movePoint(step, grip, to, size),
        );
        return;
      }
      case 'turn': {
        const turn = turnOf(multiply(toOwn, multiply(matrix, multiply(undo, parent))));
        this.#edit.offer(() => turnFrom(step, grip, turn, anchor, size));
        return;
      }
      case 'twist': {
        const degrees = aboutAxis(turnOf(multiply(undo, matrix)), [0, 0, 1]);
        const share = influence(grip.point ?? 0, this.host.range());
        this.#edit.offer(() => twistBy(step, grip.curve, degrees, share));
        return;
      }
      case 'scale': {
        const [a, b] = step.curves[grip.curve]!.scale?.[grip.point ?? 0] ?? [1, 1];
        const grown = sizesOf(multiply(undo, matrix));
        // The axis that was pulled stands for both: across the curve a limb is as good as round.
        const by = grown.reduce((most, x) => (Math.abs(x - 1) > Math.abs(most - 1) ? x : most), 1);
        const within = (x: number): number => Math.min(20, Math.max(0.05, x));
        this.#edit.offer(() => setScale(step, grip, [within(a * by), within(b * by)], this.host.range()));
      }
    }
  };

  onEnd = (): void => {
    this.#edit?.finish(this.mode());
    this.#edit = null;
    this.#grip = null;
  };

  /** Escape while the gizmo is held. */
  onCancel = (): void => {
    this.#edit?.cancel();
    this.#edit = null;
    this.#grip = null;
  };
}

function turnOf(m: Mat4): Quaternion {
  const r = rotationOf(m);
  return quaternionOf((row, column) => r[4 * column + row]!);
}

const sizesOf = (m: Mat4): number[] =>
  [0, 1, 2].map((column) => Math.hypot(m[4 * column]!, m[4 * column + 1]!, m[4 * column + 2]!));
