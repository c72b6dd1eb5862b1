import type { BufferGeometry } from 'three';
import { DensityGrid } from './density';
import { SOFT_LIGHTS } from './lights';
import type { EvenStrands } from './resample';

/** The head the hair grows on, drawn units. */
export interface Head {
  readonly geometry: BufferGeometry;
  readonly places: Float32Array;
  readonly triangles: Uint32Array;
}

/** Light in a cube around the hair, n³ cells, x fastest. */
export interface BakedLight {
  readonly n: number;
  readonly low: readonly [number, number, number];
  /** Side of the cube, drawn units. */
  readonly size: number;
  /** RGBA 0–255: openness; e^(−depth/4) towards each soft light. */
  readonly light: Uint8Array;
  /** 0–255: openness of a place to the studio's light through the hair alone, for what stands in it. */
  readonly shade: Uint8Array;
}

/** The head stops as much as this many layers of hair. */
const HEAD_OPACITY = 3;

/** @param width  of a strand at its root, drawn units */
export function bakeLight(
  strands: EvenStrands,
  width: number,
  taper: number,
  head: Pick<Head, 'places' | 'triangles'> | undefined,
): BakedLight {
  const grid = new DensityGrid(strands.low, strands.high);
  grid.addStrands(strands, (width * (1 + taper)) / 2);
  grid.smooth();
  const shade = Uint8Array.from(grid.openness(), byte);
  if (head) grid.addSurface(head.places, head.triangles, HEAD_OPACITY);
  const light = new Uint8Array(4 * grid.extinction.length);
  const put = (channel: number, values: Float32Array, of: (value: number) => number): void => {
    for (let i = 0; i < values.length; i++) light[4 * i + channel] = byte(of(values[i]!));
  };
  put(0, grid.openness(), (seen) => seen);
  const depth = new Float32Array(grid.extinction.length);
  SOFT_LIGHTS.forEach(({ towards }, k) => {
    put(k + 1, grid.depthTowards([towards.x, towards.y, towards.z], depth), (d) => Math.exp(-d / 4));
  });
  return { n: grid.n, low: grid.low, size: grid.size, light, shade };
}

const byte = (x: number): number => Math.round(255 * Math.min(1, Math.max(0, x)));
