import { describe, expect, test } from 'vitest';
import type { Model } from '../../web/core/model';
import { readModel } from '../../web/io/formats';
import { triangulate } from '../../web/io/triangulate';

type Outline = (i: number, n: number) => readonly [number, number];

const around = (i: number, n: number, r: number): readonly [number, number] => [
  r * Math.cos((2 * Math.PI * i) / n),
  r * Math.sin((2 * Math.PI * i) / n),
];

const OUTLINES: Readonly<Record<string, Outline>> = {
  circle: (i, n) => around(i, n, 1),
  star: (i, n) => around(i, n, 1 + 0.5 * (i % 2)),
  // Along one straight side, and back over teeth.
  comb: (i, n) => (2 * i < n ? [i, 0] : [n - 1 - i, i % 2 ? n / 2 : 1]),
  spiral: (i, n) => {
    const along = (2 * Math.PI * 10 * Math.min(i, n - 1 - i)) / (n / 2);
    const r = (2 * i < n ? 1 : 0.97) * (1 + along);
    return [r * Math.cos(along), r * Math.sin(along)];
  },
  square: (i, n) => {
    const [side, at] = [Math.floor((4 * i) / n), ((4 * i) / n) % 1];
    return (
      [
        [at, 0],
        [1, at],
        [1 - at, 1],
        [0, 1 - at],
      ] as const
    )[side]!;
  },
};

/** One face, in a plane that is tilted. */
function polygon(n: number, outline: Outline): Model {
  const positions = new Float64Array(3 * n);
  for (let i = 0; i < n; i++) {
    const [x, y] = outline(i, n);
    positions.set([x, y, 0.3 * x - 0.2 * y], 3 * i);
  }
  return {
    name: 'polygon',
    positions,
    faceOffsets: Uint32Array.of(0, n),
    faceVertices: Uint32Array.from({ length: n }, (_, i) => i),
  };
}

/** Twice the areas that triangles show from above. */
function areas(model: Model): Float64Array {
  const { triangles } = triangulate(model);
  const { positions: p, faceVertices: v } = model;
  return Float64Array.from({ length: triangles.length / 3 }, (_, t) => {
    const [a, b, c] = [0, 1, 2].map((k) => 3 * v[triangles[3 * t + k]!]!) as [number, number, number];
    return (p[b]! - p[a]!) * (p[c + 1]! - p[a + 1]!) - (p[b + 1]! - p[a + 1]!) * (p[c]! - p[a]!);
  });
}

describe.each(Object.entries(OUTLINES))('a %s', (name, outline) => {
  test.each([200, 20_000])('of %i corners is cut into triangles that cover it once', (n) => {
    const model = polygon(n, outline);
    const started = performance.now();
    const found = areas(model);
    console.log(`${name} of ${n}: ${Math.round(performance.now() - started)} ms`);
    expect(found.length).toBe(n - 2);
    expect(found.every((area) => area > 0)).toBe(true);
    let whole = 0;
    for (let i = 0; i < n; i++) {
      const [a, b] = [outline(i, n), outline((i + 1) % n, n)];
      whole += a[0] * b[1] - a[1] * b[0];
    }
    expect(found.reduce((sum, area) => sum + area, 0) / whole).toBeCloseTo(1, 9);
  });
});

test('an outline that crosses itself is cut up all the same, every corner used', () => {
  const { triangles } = triangulate(polygon(3001, (i, n) => around((i * 1000) % n, n, 1 + (i % 7))));
  expect(triangles.length / 3).toBe(2999);
  expect(new Set(triangles).size).toBe(3001);
});

test('a circle of many corners is cut by short lines, not from one corner', () => {
  const model = polygon(4096, (i, n) => around(i, n, 1));
  const { triangles } = triangulate(model);
  let length = 0;
  for (let t = 0; t < triangles.length; t += 3)
    for (let k = 0; k < 3; k++) {
      const turn = (triangles[t + k]! - triangles[t + ((k + 1) % 3)]!) / 4096;
      length += Math.abs(Math.sin(Math.PI * turn)); // each cut counts twice, as half its length
    }
  expect(length).toBeLessThan(4 * Math.PI * Math.log2(4096)); // from one corner: 2 * 4096 * 2 / π
});

test('a face of more corners than can be cut up is refused by its number', () => {
  const n = 100_001;
  const points = Array.from({ length: n }, (_, i) => `v ${around(i, n, 1).join(' ')} 0`);
  const face = `f ${Array.from({ length: n }, (_, i) => i + 1).join(' ')}`;
  const bytes = new TextEncoder().encode([...points, 'f 1 2 3', face].join('\n'));
  expect(() => readModel(bytes, 'disk.obj')).toThrow(
    'disk.obj: face 2 has 100,001 corners; the limit is 100,000. Cut it into smaller faces.',
  );
});
