import type { Strands } from '../../../web/core/strands';

type Point = readonly [number, number, number];

/** Strands through these points. */
export function strandsOf(lines: readonly (readonly Point[])[], more: Partial<Strands> = {}): Strands {
  const offsets = Uint32Array.of(0, ...lines.map((line) => line.length));
  for (let s = 1; s < offsets.length; s++) offsets[s]! += offsets[s - 1]!;
  return {
    offsets,
    points: Float32Array.from(lines.flat(2)),
    origin: [0, 0, 0],
    look: { thickness: 0.01, taper: 0.5, color: '#4a2f20', colorVariation: 0.2 },
    ...more,
  };
}

/** A straight strand. */
export const straight = (from: Point, to: Point, points: number): Point[] =>
  Array.from({ length: points }, (_, i) => {
    const t = i / (points - 1);
    return [0, 1, 2].map((k) => from[k]! + t * (to[k]! - from[k]!)) as unknown as Point;
  });
