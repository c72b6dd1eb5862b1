// A pose of curves as the graphics card takes it: places along the curves once, a table a move.

import type { CurveAttributes } from '../../kernel/contract/curve';
import type { MotionTable, PackedMotion, SurfaceMotion } from '../motion/types';
import type { ViewSpace } from '../view-space';
import { CURVE_GLSL, ROWS, TEXELS } from './curve-glsl';

/** Numbers of a row of the kernel's table, and of one at rest. */
const GIVEN = 20;
const AT_REST = 9;

/** Moves a model by tables of its curves (`curveTable`). */
export class CurveMotion implements SurfaceMotion {
  readonly exact = true;

  /** @param rest  the model's own positions */
  constructor(
    private readonly attributes: CurveAttributes,
    private readonly rest: Float64Array,
  ) {}

  get vertexCount(): number {
    return this.attributes.weights.length / 4;
  }

  packed(space: ViewSpace, widest: number): PackedMotion | null {
    const { curves, weights } = this.attributes;
    const height = this.attributes.slopes.length / (AT_REST * ROWS);
    const width = TEXELS * ROWS;
    const others = Math.ceil((3 * this.vertexCount) / width);
    if (Math.max(width, height, others) > widest) return null;
    const { first, texels } = placesInView(this.attributes, this.rest, space, 4 * width * others);
    return {
      glsl: CURVE_GLSL,
      inputs: [
        { name: 'curveNumbers', values: curves },
        { name: 'curveWeights', values: weights },
        { name: 'curvePlace', values: first },
      ],
      textures: [{ name: 'curvePlaces', width, height: others, texels }],
      table: { name: 'curveTable', width, height },
      tableOf: (table) => tableInView(table, this.attributes, space),
    };
  }
}

type Put = (at: number, x: number, y: number, z: number, w: number) => void;

/** Writes texels of directions, the model's turned to those drawn. */
const uprightInto =
  (out: Float32Array, { zUp }: ViewSpace): Put =>
  (at, x, y, z, w) => {
    out[at] = x;
    out[at + 1] = zUp ? z : y;
    out[at + 2] = zUp ? -y : z;
    out[at + 3] = w;
  };

/**
 * For each of a vertex's four curves how the row changes with its place, rows per drawn length, then the row: what does not
 * depend on the pose. Nothing changes beyond the ends.
 *
 * @param size  numbers of the texture of all curves but the first
 */
export function placesInView(
  { curves, rows, weights, slopes, centre }: Omit<CurveAttributes, 'frames'>,
  rest: Float64Array,
  space: ViewSpace,
  size: number,
): { readonly first: Float32Array; readonly texels: Float32Array<ArrayBuffer> } {
  const first = new Float32Array(weights.length);
  const texels = new Float32Array(size);
  const [putFirst, putOther] = [uprightInto(first, space), uprightInto(texels, space)];
  for (let k = 0; k < weights.length; k++) {
    if (weights[k] === 0) continue;
    const v = k >> 2;
    const put = k % 4 === 0 ? putFirst : putOther;
    const to = k % 4 === 0 ? k : 4 * (3 * v + (k % 4) - 1);
    const row = rows[k]!;
    if (!(row > 0 && row < ROWS - 1)) {
      put(to, 0, 0, 0, row);
      continue;
    }
    const low = Math.floor(row);
    const at = AT_REST * (ROWS * curves[k]! + low);
    const part = (i: number): number =>
      slopes[at + i]! + (row - low) * (slopes[at + AT_REST + i]! - slopes[at + i]!);
    let bend = 0;
    for (let axis = 0; axis < 3; axis++)
      bend += part(6 + axis) * (rest[3 * v + axis]! - centre[axis]! - part(axis));
    const by = 1 / (space.scale * Math.max(1 - bend, 0.05));
    put(to, by * part(3), by * part(4), by * part(5), row);
  }
  return { first, texels };
}

/**
 * The kernel's table for drawn places z = s R (y − D) instead of places y less the kernel's centre. Motions change by
 * real ↦ R real R*, dual ↦ s R (dual + r × D) R*, r the vector part of real: linear, so that blends of them are those of
 * the drawn places. Behind each row's parts stands the map of both.
 */
export function tableInView(
  table: MotionTable,
  { centre }: Pick<CurveAttributes, 'centre'>,
  space: ViewSpace,
): Float32Array<ArrayBuffer> {
  const out = new Float32Array((4 * TEXELS * table.length) / GIVEN);
  const put = uprightInto(out, space);
  const { scale: s, zUp } = space;
  const [dx, dy, dz] = [0, 1, 2].map((k) => space.centre[k]! - centre[k]!) as [number, number, number];
  const lines = [new Float64Array(4), new Float64Array(4), new Float64Array(4)] as const;
  const column = new Float64Array(3);
  for (let from = 0, at = 0; from < table.length; from += GIVEN, at += 4 * TEXELS) {
    const [rx, ry, rz, rw] = [table[from]!, table[from + 1]!, table[from + 2]!, table[from + 3]!];
    put(at, rx, ry, rz, rw);
    put(
      at + 4,
      s * (table[from + 4]! + ry * dz - rz * dy),
      s * (table[from + 5]! + rz * dx - rx * dz),
      s * (table[from + 6]! + rx * dy - ry * dx),
      s * table[from + 7]!,
    );
    for (let k = 0; k < 3; k++) {
      const line = from + 8 + 4 * k;
      const [x, y, z] = [table[line]!, table[line + 1]!, table[line + 2]!];
      const shift = x * dx + y * dy + z * dz + table[line + 3]! - (k === 0 ? dx : k === 1 ? dy : dz);
      // The model's y is −z of what is drawn, its z is y.
      const drawn = zUp && k > 0 ? 3 - k : k;
      const sign = zUp && k === 1 ? -1 : 1;
      const to = lines[drawn]!;
      to[0] = sign * x;
      to[1] = sign * (zUp ? z : y);
      to[2] = sign * (zUp ? -y : z);
      to[3] = sign * s * shift;
    }
    for (let k = 0; k < 3; k++) out.set(lines[k]!, at + 8 + 4 * k);
    compose(out.subarray(at, at + 8), lines, column);
    for (let k = 0; k < 3; k++) out.set(lines[k]!, at + 20 + 4 * k);
  }
  return out;
}

/** Puts a motion (real, dual) after an affine map in lines. @param column  for three numbers on the way */
function compose(
  motion: Float32Array,
  lines: readonly [Float64Array, Float64Array, Float64Array],
  column: Float64Array,
): void {
  const [rx, ry, rz, rw] = [motion[0]!, motion[1]!, motion[2]!, motion[3]!];
  const [tx, ty, tz, tw] = [motion[4]!, motion[5]!, motion[6]!, motion[7]!];
  const norm = 1 / (rx * rx + ry * ry + rz * rz + rw * rw);
  for (let c = 0; c < 4; c++) {
    const [x, y, z] = [lines[0][c]!, lines[1][c]!, lines[2][c]!];
    // v + 2 r × (r × v + w v), and of the last column the motion's shift too: 2 (w t − t_w r + r × t).
    const shifts = c === 3 ? 1 : 0;
    const a = ry * z - rz * y + rw * x + shifts * tx;
    const b = rz * x - rx * z + rw * y + shifts * ty;
    const d = rx * y - ry * x + rw * z + shifts * tz;
    column[0] = x + 2 * norm * (ry * d - rz * b + shifts * (rw * tx - tw * rx));
    column[1] = y + 2 * norm * (rz * a - rx * d + shifts * (rw * ty - tw * ry));
    column[2] = z + 2 * norm * (rx * b - ry * a + shifts * (rw * tz - tw * rz));
    for (let k = 0; k < 3; k++) lines[k as 0 | 1 | 2][c] = column[k]!;
  }
}
