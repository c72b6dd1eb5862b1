// Models made larger: subdivided, with scales on their skin.

import { describe, expect, test } from 'vitest';
import type { Model } from '../../web/core/model';
import { cells } from '../../web/core/scaled/cells';
import { loopSubdivided, type Surface } from '../../web/core/scaled/loop';
import { type Scaling, scaled } from '../../web/core/scaled/scaled';

const OCTAHEDRON: Surface = {
  positions: Float64Array.of(1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1),
  corners: Uint32Array.of(0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5),
};
/** Two by two squares in a plane, cut along one diagonal each. */
const SHEET: Surface = {
  positions: Float64Array.from({ length: 27 }, (_, i) => [((i / 3) % 3) | 0, Math.floor(i / 9), 0][i % 3]!),
  corners: Uint32Array.from([0, 1, 3, 4].flatMap((v) => [v, v + 1, v + 4, v, v + 4, v + 3])),
};

/** By pairs of vertices, how many triangles meet there. */
function edgesOf({ corners }: Surface): Map<string, number> {
  const edges = new Map<string, number>();
  for (let c = 0; c < corners.length; c++) {
    const pair = [corners[c]!, corners[c - (c % 3) + ((c + 1) % 3)]!].sort((a, b) => a - b);
    edges.set(`${pair}`, (edges.get(`${pair}`) ?? 0) + 1);
  }
  return edges;
}

const volumeOf = ({ positions: p, corners }: Surface): number => {
  let six = 0;
  for (let c = 0; c < corners.length; c += 3) {
    const [a, b, d] = [3 * corners[c]!, 3 * corners[c + 1]!, 3 * corners[c + 2]!];
    six +=
      p[a]! * (p[b + 1]! * p[d + 2]! - p[b + 2]! * p[d + 1]!) +
      p[a + 1]! * (p[b + 2]! * p[d]! - p[b]! * p[d + 2]!) +
      p[a + 2]! * (p[b]! * p[d + 1]! - p[b + 1]! * p[d]!);
  }
  return six / 6;
};

describe('Loop subdivision', () => {
  test('cuts each triangle into four and stays closed', () => {
    const finer = loopSubdivided(OCTAHEDRON);
    expect(finer.corners).toHaveLength(4 * 24);
    expect(finer.positions).toHaveLength(3 * (6 + 12));
    expect(new Set(edgesOf(finer).values())).toEqual(new Set([2]));
    expect(volumeOf(finer)).toBeGreaterThan(0);
  });

  test('weighs by the rules: 3/8 and 1/8 on an edge, 3/(8 n) for neighbours', () => {
    const { positions } = loopSubdivided(OCTAHEDRON);
    // Valence 4: 5/8 of the vertex, and of its four neighbours, which cancel out, nothing.
    expect([...positions.subarray(0, 3)]).toEqual([0.625, 0, 0]);
    // Between (1, 0, 0) and (0, 1, 0), opposite (0, 0, 1) and (0, 0, -1).
    expect([...positions.subarray(18, 21)]).toEqual([0.375, 0.375, 0]);
  });

  test('keeps a flat sheet flat, and its border straight', () => {
    const { positions } = loopSubdivided(loopSubdivided(SHEET));
    for (let v = 0; v < positions.length; v += 3) {
      expect(positions[v + 2]).toBe(0);
      expect(positions[v]).toBeGreaterThanOrEqual(0);
      expect(positions[v + 1]).toBeLessThanOrEqual(2);
    }
    // The middle of a side: 3/4 of itself and 1/8 of each neighbour along the border.
    expect([...loopSubdivided(SHEET).positions.subarray(3, 6)]).toEqual([1, 0, 0]);
  });

  test('takes an edge of three triangles for a crease', () => {
    const fan: Surface = {
      positions: Float64Array.of(0, 0, 0, 0, 0, 1, 1, 0, 0, -1, 0, 0, 0, 1, 0),
      corners: Uint32Array.of(0, 1, 2, 1, 0, 3, 0, 1, 4),
    };
    const finer = loopSubdivided(fan);
    expect([...finer.positions.subarray(15, 18)]).toEqual([0, 0, 0.5]);
    expect(finer.positions.every(Number.isFinite)).toBe(true);
  });
});

test('distances from seeds change no faster than one moves: none is overlooked on the way', () => {
  const [low, high, size] = [[-1, 0, 2], [1, 1.5, 3], 0.25] as const;
  const nearest = cells(low, high, size);
  const places = Array.from({ length: 400 }, (_, i) =>
    [0, 1, 2].map((k) => {
      const share = ((i + 1) * [0.7548776662466927, 0.5698402909980532, 0.4301597090019468][k]!) % 1;
      return low[k]! + share * (high[k]! - low[k]!);
    }),
  );
  for (const [x, y, z] of places as [number, number, number][]) {
    const { first, second } = { ...nearest(x, y, z) };
    expect(first).toBeLessThanOrEqual(second);
    expect(second).toBeLessThan(Math.sqrt(12));
    const near = { ...nearest(x + 0.01, y, z) };
    expect(Math.abs(near.first - first)).toBeLessThanOrEqual(0.01 / size + 1e-12);
    expect(Math.abs(near.second - second)).toBeLessThanOrEqual(0.01 / size + 1e-12);
  }
});

describe('a model with scales', () => {
  const model: Model = {
    name: 'eight.ply',
    positions: OCTAHEDRON.positions,
    faceOffsets: Uint32Array.from({ length: 9 }, (_, i) => 3 * i),
    faceVertices: OCTAHEDRON.corners,
  };
  const scaling: Scaling = { subdivisions: 4, scales: { size: 0.1, height: 0.3, below: 0.2 } };
  const made = (of = model, by = scaling) => {
    const steps: number[] = [];
    const making = scaled(of, by);
    for (;;) {
      const { done, value } = making.next();
      if (done) return { model: value, steps };
      steps.push(value);
    }
  };

  test('is made in slices that say how far they are, the same every time', () => {
    const { model: once, steps } = made();
    expect(steps[0]).toBe(0);
    expect(steps.every((at, i) => at < 1 && at >= (steps[i - 1] ?? 0))).toBe(true);
    expect(made().model.positions).toEqual(once.positions);
    expect(once.positions).toHaveLength(3 * (4 ** 4 * 4 + 2));
    expect(once.faceOffsets.at(-1)).toBe(once.faceVertices.length);
  });

  test('has them outwards, as high as asked, lower where it looks down', () => {
    const smooth = made(model, { ...scaling, scales: { ...scaling.scales, height: 0 } }).model;
    const { positions, faceVertices } = made().model;
    const height = 0.3 * 0.1 * Math.sqrt(12) * 0.625;
    const rises = { up: 0, down: 0 };
    for (let v = 0; v < positions.length; v += 3) {
      const by = [0, 1, 2].map((k) => positions[v + k]! - smooth.positions[v + k]!);
      const rise = by.reduce((sum, x, k) => sum + x * smooth.positions[v + k]!, 0);
      expect(rise).toBeGreaterThanOrEqual(-1e-15);
      const [x, y, z] = smooth.positions.subarray(v, v + 3) as unknown as [number, number, number];
      const slope = y / Math.hypot(x, y, z);
      const side = slope > 0.2 ? 'up' : slope < -0.98 ? 'down' : undefined;
      if (side) rises[side] = Math.max(rises[side], Math.hypot(...by));
    }
    expect(rises.up).toBeGreaterThan(0.3 * height);
    expect(rises.up).toBeLessThan(1.7 * height);
    expect(rises.down).toBeGreaterThan(0);
    expect(rises.down).toBeLessThan(0.4 * rises.up);
    expect(volumeOf({ positions, corners: faceVertices })).toBeGreaterThan(
      volumeOf({ positions: smooth.positions, corners: smooth.faceVertices }),
    );
  });

  test('is the same shape in other units and elsewhere', () => {
    const far = model.positions.map((x, i) => 100 * x + [50, -20, 10][i % 3]!);
    const { positions } = made({ ...model, positions: far }).model;
    const plain = made().model.positions;
    // Not to the last bit: a seed's cube is found by rounding. Hardly any vertex falls to another one.
    const off = plain.map((x, i) => Math.abs((positions[i]! - [50, -20, 10][i % 3]!) / 100 - x));
    expect(off.filter((x) => x > 1e-9).length).toBeLessThan(0.001 * off.length);
  });

  test('numbers what lies together together', () => {
    const { faceVertices } = made().model;
    let seen = -1;
    for (const v of faceVertices) {
      expect(v).toBeLessThanOrEqual(seen + 1);
      seen = Math.max(seen, v);
    }
  });

  test('is refused of faces that are no triangles', () => {
    const quad = { ...model, faceOffsets: Uint32Array.of(0, 4, 8, 12, 16, 20, 24) };
    expect(() => made(quad)).toThrow(/three corners/);
  });
});
