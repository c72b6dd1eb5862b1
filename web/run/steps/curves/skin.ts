// A step's curves as joints, for programs that know skins but not curves.

import { product, type Quaternion, quaternionOf, rotated, unitQuaternion } from '../../../core/quaternion';
import { keepLargest } from '../../../core/rig';
import { JOINT, type Skin } from '../../../core/skin';
import type { CurveAttributes } from '../../../kernel/contract/curve';
import type { CurvePosture, CurvesStep } from '../../../recipe/steps/curves';
import { type StepContext, signalOf } from '../step-runner';
import { postureOf, prepareCurves } from './kernel-words';
import { played } from './played';

/** Rows of a curve's table, and the numbers of one. */
const ROWS = 256;
const ROW = 20;
const FRAME = 12;
/** Joints of a curve: of a limb rolled up by 270 degrees two neighbours are 9 degrees apart. */
const JOINTS = 32;
/** Influences of a vertex: all that most programs read. */
const INFLUENCES = 4;
const rowOf = (joint: number): number => Math.round((joint * (ROWS - 1)) / (JOINTS - 1));

/** Joints at equal steps along every curve, each vertex moved by those beside its place: what the table's rows do, thinned out. */
export async function skinOf(step: CurvesStep, context: StepContext): Promise<Skin> {
  const { id } = await prepareCurves(step, context);
  const signal = signalOf(context);
  const attributes = await context.kernel.call('curveAttributes', { curves: id }, signal);
  const standing = async (postures: readonly CurvePosture[]) => {
    const args = { curves: id, postures: postures.map(postureOf) };
    return placed((await context.kernel.call('curveTable', args, signal)).texels, attributes);
  };
  const keys = [];
  for (const { time, curves } of played(step)) {
    const joints = await standing(curves);
    alike(joints, keys.at(-1)?.joints);
    keys.push({ time, joints });
  }
  return {
    joints: ['rest', ...step.curves.flatMap((curve) => numbered(curve.id))],
    rest: placed(undefined, attributes),
    posed: await standing(step.curves),
    ...influences(attributes),
    keys,
  };
}

const numbered = (id: string): string[] =>
  Array.from({ length: JOINTS }, (_, j) => `${id}.${String(j).padStart(2, '0')}`);

/** Joints of all curves behind the one that rests. @param texels  of a pose; none: at rest */
function placed(texels: Float32Array | undefined, { frames, centre }: CurveAttributes): Float64Array {
  const curves = frames.length / (FRAME * ROWS);
  const joints = new Float64Array(JOINT * (1 + JOINTS * curves));
  joints.set([0, 0, 0, 0, 0, 0, 1, 1, 1, 1]);
  for (let c = 0; c < curves; c++)
    for (let j = 0; j < JOINTS; j++) {
      const row = ROWS * c + rowOf(j);
      const frame = frames.subarray(FRAME * row, FRAME * (row + 1));
      const at = JOINT * (1 + JOINTS * c + j);
      const resting = turnOf(frame.subarray(3));
      if (texels) joints.set(moved(frame, resting, texels.subarray(ROW * row, ROW * (row + 1)), centre), at);
      else joints.set([frame[0]!, frame[1]!, frame[2]!, ...resting, 1, 1, 1], at);
    }
  return joints;
}

/** A rest frame as a row of the table moves it: stretched along its own axes, then turned and shifted. */
function moved(
  frame: Float64Array,
  resting: Quaternion,
  texel: Float32Array,
  centre: readonly number[],
): number[] {
  const real = unitQuaternion([...texel.subarray(0, 4)] as unknown as Quaternion);
  const length = Math.hypot(...texel.subarray(0, 4));
  const dual = [...texel.subarray(4, 8)].map((x) => x / length);
  const line = (k: number) => texel.subarray(8 + 4 * k, 12 + 4 * k);
  const origin = [0, 1, 2].map((k) => frame[k]! - centre[k]!);
  const along = (k: number) => dot(line(k), origin) + line(k)[3]!;
  const carried = cross(real, dual);
  const place = rotated(real, [along(0), along(1), along(2)]).map(
    (x, k) => x + 2 * (real[3]! * dual[k]! - dual[3]! * real[k]! + carried[k]!) + centre[k]!,
  );
  const scale = [0, 1, 2].map((axis) => {
    const a = frame.subarray(3 + 3 * axis, 6 + 3 * axis);
    return dot(
      a,
      [0, 1, 2].map((k) => dot(line(k), a)),
    );
  });
  return [...place, ...unitQuaternion(product(real, resting)), ...scale];
}

/** The two joints beside each of a vertex's places, the four that count most. */
function influences({ curves, rows, weights: shares }: CurveAttributes): Pick<Skin, 'indices' | 'weights'> {
  const vertices = rows.length / 4;
  const indices = new Uint16Array(INFLUENCES * vertices);
  const weights = new Float32Array(INFLUENCES * vertices);
  for (let v = 0; v < vertices; v++) {
    const shareOf = new Map<number, number>();
    const add = (joint: number, share: number) => shareOf.set(joint, (shareOf.get(joint) ?? 0) + share);
    let resting = 1;
    for (let k = 4 * v; k < 4 * v + 4; k++) {
      if (shares[k] === 0) continue;
      resting -= shares[k]!;
      const [curve, row] = [curves[k]!, rows[k]!];
      let j = Math.min(JOINTS - 2, Math.floor((row * (JOINTS - 1)) / (ROWS - 1)));
      while (j > 0 && rowOf(j) > row) j--;
      while (j < JOINTS - 2 && rowOf(j + 1) < row) j++;
      const along = Math.min(1, (row - rowOf(j)) / (rowOf(j + 1) - rowOf(j)));
      add(1 + JOINTS * curve + j, shares[k]! * (1 - along));
      add(2 + JOINTS * curve + j, shares[k]! * along);
    }
    if (resting > 1e-6) add(0, resting);
    const moving = [...shareOf].filter(([, share]) => share > 0);
    keepLargest({ influences: INFLUENCES, indices, weights }, v, moving);
  }
  return { indices, weights };
}

/** Turns quaternions to the side that they had before: programs blend them as they stand. */
function alike(joints: Float64Array, before: Float64Array | undefined): void {
  if (!before) return;
  for (let at = 3; at < joints.length; at += JOINT) {
    const now = joints.subarray(at, at + 4);
    if (dot(now, before.subarray(at, at + 4)) < 0) for (let k = 0; k < 4; k++) now[k]! *= -1;
  }
}

/** Of right-handed axes, one after the other. */
const turnOf = (axes: Float64Array): Quaternion => quaternionOf((row, column) => axes[3 * column + row]!);

const dot = (a: ArrayLike<number>, b: readonly number[] | Float64Array): number => {
  let sum = 0;
  for (let k = 0; k < b.length; k++) sum += a[k]! * b[k]!;
  return sum;
};

const cross = (a: readonly number[], b: readonly number[]): number[] => [
  a[1]! * b[2]! - a[2]! * b[1]!,
  a[2]! * b[0]! - a[0]! * b[2]!,
  a[0]! * b[1]! - a[1]! * b[0]!,
];
