import { expect, test } from 'vitest';
import { jitter } from '../../web/view/still';

test('the places within a pixel differ, stay in the pixel and balance', () => {
  const places = Array.from({ length: 36 }, (_, i) => jitter(i));
  expect(new Set(places.map(String)).size).toBe(36);
  for (const k of [0, 1] as const) {
    expect(Math.max(...places.map((p) => Math.abs(p[k])))).toBeLessThanOrEqual(0.5);
    expect(Math.abs(places.reduce((sum, p) => sum + p[k], 0) / 36)).toBeLessThan(0.03);
  }
});
