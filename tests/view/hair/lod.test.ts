import { describe, expect, test } from 'vitest';
import { firstShare, nextShare, prefixOf, restShare, WIDEST } from '../../../web/view/hair/lod';

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
    let share = firstShare(100_000, false);
    for (let i = 0; i < 20; i++) share = nextShare(share, 200, 100_000);
    expect(share).toBeCloseTo(0.02);
    for (let i = 0; i < 60; i++) share = nextShare(share, 8, 100_000);
    expect(share).toBe(1);
  });

  test('falls at once when one picture takes seconds', () => {
    expect(nextShare(1, 4000, 100_000)).toBeCloseTo(0.02);
  });

  test('is small from the start where there is no graphics card, and at rest too', () => {
    const share = firstShare(20_000, true);
    expect(share).toBeCloseTo(0.1);
    expect(restShare(share, true)).toBeCloseTo(0.2);
    expect(restShare(share, false)).toBe(1);
  });

  test('rests between', () => {
    expect(nextShare(0.4, 20, 100_000)).toBe(0.4);
  });
});
