import { expect, test } from 'vitest';
import { usualFeather } from '../../../web/tools/blend/feather';
import { tube } from './tube';

test('a feather is as wide as suits the part, at any size', () => {
  for (const size of [1, 700]) {
    const { positions, triangles } = tube(() => 0.2 * size, { height: size });
    const all = Array.from({ length: positions.length / 3 }, (_, v) => v);
    const area = 2 * Math.PI * 0.2 * 1 + 2 * Math.PI * 0.04;
    expect(usualFeather(positions, triangles, all) / size).toBeCloseTo(0.7 * Math.sqrt(area / Math.PI), 2);
    expect(usualFeather(positions, triangles, [1, 2])).toBe(0);
  }
});
