import { describe, expect, test } from 'vitest';
import { hullLength, loopLength, sectionLoop } from '../../../web/tools/blend/section';
import { tube } from './tube';

const UP = [0, 1, 0] as const;
const AROUND = 24;
/** Of a regular polygon in a circle of radius 1. */
const POLYGON = 2 * AROUND * Math.sin(Math.PI / AROUND);

describe('a tube cut across', () => {
  const { positions, triangles } = tube(() => 0.2);

  test('has the girth of its rings, whichever vertex of a ring is named', () => {
    for (const vertex of [10 * AROUND, 10 * AROUND + 7, 25 * AROUND + 3]) {
      const loop = sectionLoop(positions, triangles, vertex, UP)!;
      expect(loopLength(loop)).toBeCloseTo(0.2 * POLYGON, 9);
      expect(hullLength(loop, UP)).toBeCloseTo(0.2 * POLYGON, 9);
      for (let i = 1; i < loop.length; i += 3) expect(loop[i]).toBeCloseTo(positions[3 * vertex + 1]!, 12);
    }
  });

  test('the length of the normal is of no account, nor is its sign', () => {
    const once = loopLength(sectionLoop(positions, triangles, 10 * AROUND, [0, 3, 0])!);
    expect(loopLength(sectionLoop(positions, triangles, 10 * AROUND, [0, -1, 0])!)).toBeCloseTo(once, 6);
  });

  test('a slanted cut is longer', () => {
    const loop = sectionLoop(positions, triangles, 20 * AROUND, [0.5, 1, 0])!;
    expect(loopLength(loop)).toBeGreaterThan(0.2 * POLYGON * 1.03);
  });

  test('of two tubes side by side the one of the vertex is measured', () => {
    const other = tube(() => 0.5, { shift: [3, 0, 0] });
    const count = positions.length / 3;
    const both = Float64Array.from([...positions, ...other.positions]);
    const faces = Uint32Array.from([...triangles, ...other.triangles.map((v) => v + count)]);
    expect(loopLength(sectionLoop(both, faces, 10 * AROUND, UP)!)).toBeCloseTo(0.2 * POLYGON, 9);
    expect(loopLength(sectionLoop(both, faces, count + 10 * AROUND, UP)!)).toBeCloseTo(0.5 * POLYGON, 9);
  });

  test('an open surface has no girth where the cut runs into its edge', () => {
    const half = Uint32Array.from(
      [...Array(triangles.length / 3).keys()]
        .filter((t) => [0, 1, 2].every((c) => positions[3 * triangles[3 * t + c]!]! > -0.1))
        .flatMap((t) => [...triangles.subarray(3 * t, 3 * t + 3)]),
    );
    expect(sectionLoop(positions, half, 10 * AROUND, UP)).toBeNull();
  });
});

test('a tape lies over hollows', () => {
  // A star of eight points: its hull is the octagon of the outer ones.
  const loop = Float64Array.from(
    [...Array(16).keys()].flatMap((i) => {
      const r = i % 2 ? 0.4 : 1;
      return [r * Math.cos((i * Math.PI) / 8), 2, r * Math.sin((i * Math.PI) / 8)];
    }),
  );
  expect(hullLength(loop, UP)).toBeCloseTo(16 * Math.sin(Math.PI / 8), 12);
  expect(loopLength(loop)).toBeGreaterThan(hullLength(loop, UP));
});
