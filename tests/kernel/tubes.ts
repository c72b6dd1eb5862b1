// Open tubes to be merged: n rows of m vertices, the open loop first, closed by one vertex at the far end.

import type { Shape } from './shapes';

export type Profile = (along: number, around: number) => readonly [number, number, number];

export const dome: Profile = (s, t) => [Math.cos(t) * (1 - s ** 3), 2 * s, Math.sin(t) * (1 - s ** 3)];
export const bowl: Profile = (s, t) => [
  Math.cos(t) * (1 - s ** 4) * 1.4,
  -2 * s,
  Math.sin(t) * (1 - s ** 4) * 1.4,
];

/** @param upward  the profile rises as seen from inside, so that faces look outward */
export function tube(n: number, m: number, profile: Profile, upward = true): Shape {
  const positions: number[] = [];
  const corners: number[] = [];
  for (let i = 0; i < n; i++)
    for (let j = 0; j < m; j++) positions.push(...profile(i / n, (2 * Math.PI * j) / m));
  positions.push(...profile(1, 0));
  const add = (a: number, b: number, c: number) => corners.push(...(upward ? [a, b, c] : [a, c, b]));
  for (let i = 0; i + 1 < n; i++)
    for (let j = 0; j < m; j++) {
      const k = (j + 1) % m;
      add(i * m + j, (i + 1) * m + j, (i + 1) * m + k);
      add(i * m + j, (i + 1) * m + k, i * m + k);
    }
  for (let j = 0; j < m; j++) add((n - 1) * m + j, n * m, (n - 1) * m + ((j + 1) % m));
  return {
    positions: Float64Array.from(positions),
    faceOffsets: Uint32Array.from({ length: corners.length / 3 + 1 }, (_, f) => 3 * f),
    faceVertices: Uint32Array.from(corners),
  };
}
