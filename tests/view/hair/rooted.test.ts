import { expect, test } from 'vitest';
import type { EvenStrands } from '../../../web/view/hair/resample';
import { rootDensity } from '../../../web/view/hair/rooted';

/** Strands of two points on a square lawn from 0 to 1, `n` a side. */
function lawn(n: number): EvenStrands {
  const points = new Float32Array(6 * n * n);
  for (let s = 0; s < n * n; s++)
    points.set([(s % n) / (n - 1), 0, Math.floor(s / n) / (n - 1), 9, 9, 9], 6 * s);
  return { count: n * n, perStrand: 2, points, low: [0, 0, 0], high: [9, 9, 9] };
}
const PLACES = Float32Array.of(0.5, 0, 0.5, 0.3, 0, 0.7, 1.2, 0, 0.5, 0.5, 0.5, 0.5, NaN, 0, 0);

test('a vertex amid the hair is as dense as hair gets, one away from it is bare', () => {
  const [amid, also, beside, above, nowhere] = rootDensity(lawn(121), PLACES);
  expect(amid).toBeGreaterThan(200);
  expect(also).toBeGreaterThan(200);
  expect([beside, above, nowhere]).toEqual([0, 0, 0]);
});

test('density falls off at the edge of the hair, and does not depend on how much hair there is', () => {
  const edge = Float32Array.of(0, 0, 0.5);
  for (const n of [81, 121]) {
    const [at] = rootDensity(lawn(n), edge);
    expect(at).toBeGreaterThan(100);
    expect(at).toBeLessThan(220);
  }
});

test('without hair a head is bare', () => {
  expect(rootDensity({ ...lawn(2), count: 0 }, PLACES)).toEqual(new Uint8Array(5));
});
