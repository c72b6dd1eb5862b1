import { describe, expect, test } from 'vitest';
import { clearances } from '../../../web/tools/dress/clearance';
import { tube } from '../blend/tube';

describe.each([1, 250])('cloth about a tube of %f', (size) => {
  const body = tube(() => 0.2 * size, { height: size, around: 48, rings: 60 });
  const at = (out: number) =>
    Float64Array.from(
      [...Array(12).keys()].flatMap((k) => [
        (0.2 * size + out) * Math.cos(k),
        0.5 * size,
        (0.2 * size + out) * Math.sin(k),
      ]),
    );

  test('lies as far from it as it is off', () => {
    for (const out of [0.004, 0.02, 0.4])
      for (const far of clearances(at(out * size), body.positions, body.triangles))
        expect(Math.abs(far - out * size)).toBeLessThan(0.004 * size + 0.1 * out * size);
  });

  test('is inside where it is less than 0', () => {
    for (const far of clearances(at(-0.01 * size), body.positions, body.triangles))
      expect(far).toBeLessThan(0);
  });
});

test('far away is found too', () => {
  const body = tube(() => 0.2);
  const [far] = clearances(Float64Array.of(40, 0.5, 0), body.positions, body.triangles);
  expect(far).toBeCloseTo(39.8, 0);
});
