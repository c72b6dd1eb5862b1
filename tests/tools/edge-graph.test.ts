import { describe, expect, test } from 'vitest';
import { EdgeGraph } from '../../web/tools/edge-graph';

/** A drum of `n` sides: vertices 2i below and 2i + 1 above, its ends in the middle; quads and fans. */
function drum(n: number, height = 1) {
  const positions: number[] = [];
  for (let i = 0; i < n; i++) {
    const [x, z] = [Math.cos((2 * Math.PI * i) / n), Math.sin((2 * Math.PI * i) / n)];
    positions.push(x, 0, z, x, height, z);
  }
  positions.push(0, 0, 0, 0, height, 0);
  const triangles: number[] = [];
  const faceOfTriangle: number[] = [];
  for (let i = 0; i < n; i++) {
    const [a, b, c, d] = [2 * i, 2 * i + 1, (2 * i + 2) % (2 * n), (2 * i + 3) % (2 * n)];
    triangles.push(a, b, c, c, b, d, 2 * n, a, c, 2 * n + 1, d, b);
    faceOfTriangle.push(4 * i, 4 * i, 4 * i + 1, 4 * i + 2);
  }
  return {
    positions: Float64Array.from(positions),
    triangles: Uint32Array.from(triangles),
    faceOfTriangle: Uint32Array.from(faceOfTriangle),
    welded: Int32Array.from({ length: 2 * n + 2 }, (_, v) => v),
  };
}

const edgeOf = (graph: EdgeGraph, a: number, b: number): number =>
  [...graph.edgesAt(a)].find((edge) => graph.verticesOf(edge).includes(b))!;

describe('a drum of 24 sides', () => {
  const graph = new EdgeGraph(drum(24));

  test('knows how sharp its edges are, and none inside a face', () => {
    expect(graph.angleOf(edgeOf(graph, 0, 2))).toBeCloseTo(90, 4);
    expect(graph.angleOf(edgeOf(graph, 0, 1))).toBeCloseTo(15, 4);
    expect(graph.angleOf(edgeOf(graph, 0, 48))).toBeCloseTo(0, 4);
    expect(edgeOf(graph, 1, 2)).toBeUndefined();
  });

  test('has a rim that is one closed line', () => {
    const rim = graph.chain(edgeOf(graph, 1, 3));
    expect(rim).toHaveLength(25);
    expect(rim[0]).toBe(rim.at(-1));
    expect(new Set(rim)).toEqual(new Set(Array.from({ length: 24 }, (_, i) => 2 * i + 1)));
  });

  test('gives a smooth edge alone', () => {
    expect(graph.chain(edgeOf(graph, 0, 48)).sort((a, b) => a - b)).toEqual([0, 48]);
  });

  test('is crossed by the shortest way, which keeps to creases where that is asked for', () => {
    expect(graph.path(1, 25, false)).toEqual([1, 49, 25]);
    expect(graph.path(1, 7, true)).toEqual([1, 3, 5, 7]);
    expect(graph.path(4, 4, true)).toEqual([4]);
  });
});

test('lines end where they turn, and where three meet', () => {
  const box = new EdgeGraph(drum(4));
  for (const [a, b] of [
    [0, 2],
    [0, 1],
  ] as const)
    expect(box.chain(edgeOf(box, a, b)).sort()).toEqual([a, b]);
});

test('a turned corner ends a line even where no third edge meets', () => {
  // Two flaps bent up along two sides of a square: the crease turns by 90 degrees at vertex 1.
  const graph = new EdgeGraph({
    positions: Float64Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1),
    triangles: Uint32Array.of(0, 1, 2, 0, 2, 3, 0, 5, 1, 0, 4, 5, 1, 5, 2, 2, 5, 6),
    faceOfTriangle: Uint32Array.of(0, 0, 1, 1, 2, 2),
    welded: Int32Array.of(0, 1, 2, 3, 4, 5, 6),
  });
  expect(graph.chain(edgeOf(graph, 0, 1)).sort()).toEqual([0, 1]);
});

test('copies of one point are one place, and nothing leads to another piece', () => {
  const graph = new EdgeGraph({
    positions: Float64Array.of(
      0,
      0,
      0,
      1,
      0,
      0,
      0,
      1,
      0,
      1,
      0,
      0,
      0,
      1,
      0,
      1,
      1,
      0,
      5,
      0,
      0,
      6,
      0,
      0,
      5,
      1,
      0,
    ),
    triangles: Uint32Array.of(0, 1, 2, 3, 5, 4, 6, 7, 8),
    faceOfTriangle: Uint32Array.of(0, 1, 2),
    welded: Int32Array.of(0, 1, 2, 1, 2, 3, 4, 5, 6),
  });
  expect(graph.path(0, 5, false)).toHaveLength(3);
  expect(graph.firstCopy(4)).toBe(2);
  expect(graph.path(0, 7, false)).toBeNull();
  expect(graph.path(0, 99, false)).toBeNull();
});
