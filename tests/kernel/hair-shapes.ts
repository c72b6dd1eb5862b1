// A head by formula: an egg 24 cm high, and the strokes of three styles on it.

import type { HairStyle } from '../../web/kernel/contract/hair';
import type { Shape } from './shapes';

const RADII = [0.09, 0.12, 0.1] as const;
const RINGS = 24;
const SECTORS = 36;

type Point = [number, number, number];

/** The place on the egg that lies this way from its middle, and so much above the skin. */
export function skin(way: Point, above = 0): Point {
  const length = Math.hypot(...way);
  return way.map((x, d) => (x / length) * (RADII[d]! + above)) as Point;
}

/** Squared length in units of the egg's radii: below 1 is inside. */
export const depth = (x: number, y: number, z: number): number =>
  (x / RADII[0]) ** 2 + (y / RADII[1]) ** 2 + (z / RADII[2]) ** 2;

export function egg(): Shape {
  const points: Point[] = [skin([0, 1, 0])];
  for (let r = 1; r < RINGS; r++)
    for (let s = 0; s < SECTORS; s++) {
      const [a, b] = [(Math.PI * r) / RINGS, (2 * Math.PI * s) / SECTORS];
      points.push(skin([Math.sin(a) * Math.sin(b), Math.cos(a), Math.sin(a) * Math.cos(b)]));
    }
  points.push(skin([0, -1, 0]));
  const at = (r: number, s: number): number =>
    r === 0 ? 0 : r === RINGS ? points.length - 1 : 1 + (r - 1) * SECTORS + (s % SECTORS);
  const faces: number[][] = [];
  for (let r = 0; r < RINGS; r++)
    for (let s = 0; s < SECTORS; s++) {
      if (r > 0) faces.push([at(r, s), at(r + 1, s), at(r, s + 1)]);
      if (r < RINGS - 1) faces.push([at(r, s + 1), at(r + 1, s), at(r + 1, s + 1)]);
    }
  return {
    positions: Float64Array.from(points.flat()),
    faceOffsets: Uint32Array.from({ length: faces.length + 1 }, (_, f) => 3 * f),
    faceVertices: Uint32Array.from(faces.flat()),
  };
}

/** Its upper half, but for a face in front. */
export function scalpOf({ positions }: Shape): Uint32Array {
  const scalp: number[] = [];
  for (let v = 0; v < positions.length / 3; v++)
    if (positions[3 * v + 1]! > -0.02 && positions[3 * v + 2]! < 0.08) scalp.push(v);
  return Uint32Array.from(scalp);
}

/** Lines from the crown down on all sides. */
export function combedDown(): Point[][] {
  return Array.from({ length: 8 }, (_, k) =>
    Array.from({ length: 20 }, (_, i) => {
      const [t, a] = [0.3 + 0.1 * i, (Math.PI * k) / 4];
      return skin([Math.sin(t) * Math.sin(a), Math.cos(t), Math.sin(t) * Math.cos(a)], 0.006);
    }),
  );
}

export const style = (lines: readonly Point[][]): HairStyle => ({
  streams: lines.map((points) => ({ points: Float64Array.from(points.flat()), fade: false })),
  partings: [],
  ponytails: [],
});
