import { LissomError } from '../core/errors';
import type { Model } from '../core/model';
import type { PlyElement, PlyProperty, PlyType } from './ply-header';
import type { PlyValues } from './ply-values';

/** One scalar property, kept as it came. */
export interface PlyColumn {
  readonly name: string;
  readonly type: PlyType;
  readonly values: Float64Array;
}

type PerVertex = Pick<Model, 'positions' | 'colors' | 'colorAlpha' | 'uvs' | 'vertexSets'>;

/** Where a property's values go: row r lands at `out[stride · r + offset]`, times `scale`. */
interface Sink {
  readonly type: PlyType;
  readonly countType: PlyType | undefined;
  readonly out: Float64Array | Uint8ClampedArray | undefined;
  readonly stride: number;
  readonly offset: number;
  readonly scale: number;
}

const COLORS = ['red', 'green', 'blue', 'alpha'];
const SHORT_COLORS = ['r', 'g', 'b', 'a'];
const NORMALS = new Set(['nx', 'ny', 'nz']);
/** In the order of preference; the pairs that programs write. */
const UV_NAMES = [
  ['s', 't'],
  ['u', 'v'],
  ['texture_u', 'texture_v'],
  ['texture_s', 'texture_t'],
] as const;

/** @throws LissomError `file-not-a-mesh` without x, y, z; `file-truncated` */
export function readVertices(
  values: PlyValues,
  { count, properties }: PlyElement,
  file: string,
): PerVertex & { columns: PlyColumn[]; normals: boolean } {
  const named = (name: string) => properties.find((p) => p.name === name && !p.countType);
  const axes = ['x', 'y', 'z'].map(named);
  if (axes.includes(undefined)) {
    const message = `The vertices of ${file} have no x, y and z, so it holds no model. Open another file.`;
    throw new LissomError('file-not-a-mesh', message);
  }
  const colorNames = [COLORS, SHORT_COLORS].find((names) => names.slice(0, 3).every(named)) ?? [];
  const uvNames = UV_NAMES.find((pair) => pair.every(named));
  const colorAlpha = colorNames.length > 0 && named(colorNames[3]!) !== undefined;
  const positions = new Float64Array(3 * count);
  const colors = colorNames.length > 0 ? new Uint8ClampedArray(4 * count).fill(255) : undefined;
  const uvs = uvNames && new Float64Array(2 * count);
  const loose: PlyColumn[] = [];

  const sink = (property: PlyProperty): Sink => {
    const { name, type, countType } = property;
    const to = (out: Sink['out'], stride: number, offset: number, scale = 1): Sink => ({
      type,
      countType,
      out,
      stride,
      offset,
      scale,
    });
    if (countType || NORMALS.has(name)) return to(undefined, 0, 0);
    if (axes.includes(property)) return to(positions, 3, axes.indexOf(property));
    if (colors && colorNames.includes(name)) return to(colors, 4, colorNames.indexOf(name), colorScale(type));
    if (uvs && (uvNames as readonly string[]).includes(name))
      return to(uvs, 2, (uvNames as readonly string[]).indexOf(name));
    const column: PlyColumn = { name, type, values: new Float64Array(count) };
    loose.push(column);
    return to(column.values, 1, 0);
  };
  readRows(values, count, properties.map(sink));

  const sets = new Set(loose.filter(isVertexSet));
  return {
    positions,
    ...(colors && { colors: new Uint8Array(colors.buffer), colorAlpha }),
    ...(uvs && { uvs }),
    ...(sets.size > 0 && {
      vertexSets: Object.fromEntries([...sets].map((c) => [c.name, members(c.values)])),
    }),
    columns: loose.filter((column) => !sets.has(column)),
    normals: properties.some((p) => p.name === 'nx'),
  };
}

function readRows(values: PlyValues, count: number, sinks: readonly Sink[]): void {
  for (let row = 0; row < count; row++)
    for (const { type, countType, out, stride, offset, scale } of sinks) {
      if (countType) {
        const length = values.next(countType);
        for (let i = 0; i < length; i++) values.next(type);
      } else {
        const value = values.next(type);
        if (out) out[stride * row + offset] = value * scale;
      }
    }
}

/** From the type's range to 0–255. */
function colorScale(type: PlyType): number {
  if (type === 'float' || type === 'double') return 255;
  return type === 'ushort' ? 1 / 257 : 1;
}

const isVertexSet = ({ type, values }: PlyColumn): boolean =>
  type === 'uchar' && values.every((value) => value === 0 || value === 1);

function members(values: Float64Array): Uint32Array {
  const out: number[] = [];
  for (let i = 0; i < values.length; i++) if (values[i] === 1) out.push(i);
  return Uint32Array.from(out);
}
