// A drag by isolines as the graphics card takes it: fields once, transformations a move.

import type { MotionTable, PackedMotion, SurfaceMotion } from '../motion/types';
import type { ViewSpace } from '../view-space';
import { isolineGlsl } from './isoline-glsl';
import type { IsolineSurface } from './types';

/** Moves it by 12 numbers a control, rows of [A − 1 | b]. What remains is the unreduced method's. */
export class IsolineMotion implements SurfaceMotion {
  readonly exact = false;

  constructor(readonly surface: IsolineSurface) {}

  get vertexCount(): number {
    return this.surface.fields.length / this.surface.sets;
  }

  packed(space: ViewSpace, widest: number): PackedMotion | null {
    const { surface } = this;
    const fields = packFields(surface, space, widest);
    const height = surface.sets * surface.controls;
    if (!fields || height > widest) return null;
    return {
      glsl: isolineGlsl(surface, fields.steepest),
      inputs: [],
      textures: [{ name: 'isolineFields', ...fields }],
      table: { name: 'isolineOffsets', width: 3, height },
      tableOf: (offsets) => offsetsInView(offsets, space),
    };
  }
}

/** Whole numbers from 0 to 1. */
const UNIT = 65535;
/** The gradient's code of a vertex that stays: no gradient has it. */
const STILL = 65535;
const HALF = 32767;

export interface PackedFields {
  /** Four numbers a vertex and set: the gradient's x, y, z about `HALF`, then the value. */
  readonly texels: Uint16Array<ArrayBuffer>;
  readonly width: number;
  readonly height: number;
  /** Of the longest part of a gradient, 1 per drawn unit. */
  readonly steepest: number;
}

/** @param widest  of a texture. @returns `null` where they do not fit into one */
export function packFields(surface: IsolineSurface, space: ViewSpace, widest: number): PackedFields | null {
  const { sets, fields, gradients, still } = surface;
  const count = fields.length;
  const width = Math.max(1, Math.min(widest, count));
  const height = Math.max(1, Math.ceil(count / width));
  if (height > widest) return null;
  let steepest = 0;
  for (const part of gradients) steepest = Math.max(steepest, Math.abs(part));
  const scale = steepest > 0 ? HALF / steepest : 0;
  const code = (part: number): number => HALF + Math.round(part * scale);
  const texels = new Uint16Array(4 * width * height);
  for (let i = 0; i < count; i++) {
    const stays = still?.[Math.floor(i / sets)] === 1;
    const [x, y, z] = [gradients[3 * i]!, gradients[3 * i + 1]!, gradients[3 * i + 2]!];
    texels[4 * i] = stays ? STILL : code(x);
    texels[4 * i + 1] = code(space.zUp ? z : y);
    texels[4 * i + 2] = code(space.zUp ? -y : z);
    texels[4 * i + 3] = Math.round(UNIT * fields[i]!);
  }
  return { texels, width, height, steepest: steepest / space.scale };
}

/**
 * Offsets of transformations of drawn places instead of the model's.
 *
 * @param offsets  12 numbers each, rows of [A − 1 | b]
 */
export function offsetsInView(
  offsets: MotionTable,
  { centre, scale, zUp }: ViewSpace,
): Float32Array<ArrayBuffer> {
  const out = new Float32Array(offsets.length);
  const row = [0, 0, 0, 0];
  for (let at = 0; at < offsets.length; at += 12)
    for (let k = 0; k < 3; k++) {
      const from = at + 4 * k;
      const by = offsets[from]! * centre[0] + offsets[from + 1]! * centre[1] + offsets[from + 2]! * centre[2];
      row[0] = offsets[from]!;
      row[1] = zUp ? offsets[from + 2]! : offsets[from + 1]!;
      row[2] = zUp ? -offsets[from + 1]! : offsets[from + 2]!;
      row[3] = scale * (by + offsets[from + 3]!);
      // The model's y is −z of what is drawn, its z is y.
      const drawn = zUp && k > 0 ? 3 - k : k;
      const sign = zUp && k === 1 ? -1 : 1;
      for (let c = 0; c < 4; c++) out[at + 4 * drawn + c] = sign * row[c]!;
    }
  return out;
}
