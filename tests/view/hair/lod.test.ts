import { describe, expect, test } from 'vitest';
import { firstShare, nextShare, prefixOf, WIDEST } from '../../../web/view/hair/lod';
import { jitter } from '../../../web/view/hair/still';

describe('a prefix of the strands', () => {
  test('covers the same area, until strands would be too thick', () => {
    for (const share of [1, 0.8, 0.5, 0.34]) {
      const { count, widthScale } = prefixOf(100_000, share);
      expect(count * widthScale).toBeCloseTo(100_000, 6);
    }
    expect(prefixOf(100_000, 0.01).widthScale).toBe(WIDEST);
  });

  test('is never empty where there is hair, and never longer than all of it', () => {
    expect(prefixOf(3, 0).count).toBe(1);
    expect(prefixOf(3, 9)).toEqual({ count: 3, widthScale: 1 });
    expect(prefixOf(3, Number.NaN).count).toBe(3);
    expect(prefixOf(0, 1).count).toBe(0);
  });
});

describe('the share while moving', () => {
  test('falls when pictures are late, down to a floor, and returns when they are early', () => {
    let share = firstShare(100_000);
    for (let i = 0; i < 20; i++) share = nextShare(share, 200, 100_000);
    expect(share).toBeCloseTo(0.02);
    for (let i = 0; i < 60; i++) share = nextShare(share, 8, 100_000);
    expect(share).toBe(1);
  });

  test('rests between', () => {
    expect(nextShare(0.4, 20, 100_000)).toBe(0.4);
  });
});

test('the places within a pixel differ, stay in the pixel and balance', () => {
  const places = Array.from({ length: 36 }, (_, i) => jitter(i));
  expect(new Set(places.map(String)).size).toBe(36);
  for (const k of [0, 1] as const) {
    expect(Math.max(...places.map((p) => Math.abs(p[k])))).toBeLessThanOrEqual(0.5);
    expect(Math.abs(places.reduce((sum, p) => sum + p[k], 0) / 36)).toBeLessThan(0.03);
  }
});
