import { describe, expect, test } from 'vitest';
import { SurfaceGraph } from '../../web/view/surface-graph';
import { both, identityWeld, type Shape, sheet, sphere } from './shapes';

const graphOf = ({ positions, triangles }: Shape): SurfaceGraph =>
  new SurfaceGraph(triangles, identityWeld(positions.length / 3));

const inBall = (x: Float64Array, c: readonly number[], r: number): number[] =>
  Array.from({ length: x.length / 3 }, (_, v) => v).filter(
    (v) => Math.hypot(x[3 * v]! - c[0]!, x[3 * v + 1]! - c[1]!, x[3 * v + 2]! - c[2]!) <= r,
  );

describe('a brush', () => {
  test('takes every vertex in its ball where the surface is one sheet', () => {
    const flat = sheet(20);
    const centre = [7.3, 9.1, 0] as const;
    const start = 2 * (9 * 20 + 7);
    const found = graphOf(flat).verticesInBall(flat.positions, start, [...centre], 4.2);
    expect([...found]).toEqual(inBall(flat.positions, centre, 4.2));
  });

  test('does not reach a second sheet, however near', () => {
    const pair = both(sheet(10, 0), sheet(10, 0.1));
    const found = graphOf(pair).verticesInBall(pair.positions, 2 * (5 * 10 + 5), [5.4, 5.6, 0], 3);
    expect(found.length).toBeGreaterThan(20);
    expect(Math.max(...found)).toBeLessThan(121);
  });

  test('reaches the other side of a sphere only when the ball holds the way there', () => {
    const ball = sphere(16);
    const graph = graphOf(ball);
    const top = nearestTriangle(ball, [0, 1, 0]);
    for (const radius of [0.3, 1, 1.7, 2.001]) {
      const found = graph.verticesInBall(ball.positions, top, [0, 1, 0], radius);
      expect([...found]).toEqual(inBall(ball.positions, [0, 1, 0], radius));
    }
  });

  test('passes through triangles larger than itself, and may hold no vertex at all', () => {
    const flat = sheet(1);
    const graph = graphOf(flat);
    // Over the diagonal: the corner (1, 0) belongs to the other triangle.
    expect([...graph.verticesInBall(flat.positions, 1, [0.48, 0.52, 0], 0.75)]).toEqual([0, 1, 2, 3]);
    expect([...graph.verticesInBall(flat.positions, 1, [0.3, 0.7, 0], 0.1)]).toEqual([]);
  });

  test('crosses a seam of the file and brings both twins along', () => {
    const positions = Float64Array.of(0, 0, 0, 0, 1, 0, -1, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0);
    const graph = new SurfaceGraph(Uint32Array.of(0, 1, 2, 4, 3, 5), Int32Array.of(0, 1, 2, 0, 1, 3));
    expect([...graph.verticesInBall(positions, 0, [-0.1, 0.1, 0], 0.5)]).toEqual([0, 3]);
  });

  test('asks the same twice and gets the same', () => {
    const ball = sphere(8);
    const graph = graphOf(ball);
    const ask = (): number[] => [...graph.verticesInBall(ball.positions, 3, [0, 0, -1], 0.7)];
    expect(ask()).toEqual(ask());
  });
});

describe('a soft mask', () => {
  test('is above a half exactly on the set', () => {
    const flat = sheet(20);
    const set = Uint32Array.from(inBall(flat.positions, [8, 8, 0], 5.3));
    const { vertices, values } = graphOf(flat).softMask(set);
    const above = vertices.filter((_, i) => values[i]! > 0.5);
    expect([...above]).toEqual([...set]);
    expect(Math.min(...values)).toBeGreaterThan(0);
    expect(Math.max(...values)).toBeLessThanOrEqual(1);
  });

  test('keeps a lone vertex', () => {
    const { vertices, values } = graphOf(sheet(10)).softMask(Uint32Array.of(60));
    expect([...vertices.filter((_, i) => values[i]! > 0.5)]).toEqual([60]);
  });
});

test('sets touch when they share a vertex or an edge joins them, else not', () => {
  const graph = graphOf(sheet(4));
  expect(graph.touching(Uint32Array.of(0, 1), Uint32Array.of(1))).toBe(true);
  expect(graph.touching(Uint32Array.of(0), Uint32Array.of(1))).toBe(true);
  expect(graph.touching(Uint32Array.of(0), Uint32Array.of(2))).toBe(false);
});

function nearestTriangle({ positions, triangles }: Shape, to: readonly number[]): number {
  let best = 0;
  let least = Infinity;
  for (let t = 0; t < triangles.length / 3; t++) {
    let gap = 0;
    for (let k = 0; k < 3; k++) {
      const middle = [0, 1, 2].reduce((sum, c) => sum + positions[3 * triangles[3 * t + c]! + k]! / 3, 0);
      gap += (middle - to[k]!) ** 2;
    }
    if (gap < least) [best, least] = [t, gap];
  }
  return best;
}
