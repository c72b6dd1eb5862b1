import { describe, expect, test } from 'vitest';
import { Levels } from '../../../web/tools/blend/levels';
import { tube } from './tube';

/** Wide at the hips and the chest, narrow between. */
const figure = (share: number): number =>
  0.1 + 0.05 * Math.exp(-(((share - 0.5) / 0.05) ** 2)) + 0.06 * Math.exp(-(((share - 0.73) / 0.05) ** 2));

describe.each([1, 1800])('a figure %f units tall', (size) => {
  const { positions, triangles } = tube((share) => size * figure(share), { rings: 100, height: size });
  const levels = new Levels(positions, triangles, [0, 1, 0]);

  test('stands upright', () => {
    expect(levels.isUpright).toBe(true);
    expect(levels.height).toBeCloseTo(size, 9);
  });

  test('is measured where it is widest and narrowest', () => {
    expect(Math.abs(levels.shareOf(levels.preset('hip')!) - 0.5)).toBeLessThan(0.01);
    expect(Math.abs(levels.shareOf(levels.preset('chest')!) - 0.73)).toBeLessThan(0.01);
    const waist = levels.shareOf(levels.preset('waist')!);
    expect(waist).toBeGreaterThan(0.58);
    expect(waist).toBeLessThan(0.65);
  });

  test('a tape moves up and down, and back', () => {
    const hip = levels.preset('hip')!;
    const up = levels.moved(hip, 0.01);
    expect(levels.shareOf(up)).toBeGreaterThan(levels.shareOf(hip));
    expect(levels.shareOf(levels.moved(hip, -0.01))).toBeLessThan(levels.shareOf(hip));
    expect(levels.shareOf(levels.moved(up, -0.01))).toBeCloseTo(levels.shareOf(hip), 9);
  });
});

test('the chest lies below the arms: where the cut jumps, the tape stops', () => {
  const arms = (share: number): number => figure(share) + (share > 0.7 ? 0.3 : 0);
  const { positions, triangles } = tube(arms, { rings: 200 });
  const levels = new Levels(positions, triangles, [0, 1, 0]);
  expect(levels.shareOf(levels.preset('chest')!)).toBeLessThan(0.705);
});

test('a head, a heap and a body that lies down do not stand like a body', () => {
  const upright = (radius: number, up: readonly [number, number, number]) => {
    const { positions, triangles } = tube(() => radius);
    return new Levels(positions, triangles, up).isUpright;
  };
  expect(upright(0.35, [0, 1, 0])).toBe(false);
  expect(upright(2, [0, 1, 0])).toBe(false);
  expect(upright(0.1, [0, 0, 1])).toBe(false);
});
