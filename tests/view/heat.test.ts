import { describe, expect, test } from 'vitest';
import { heatColour, heatGradient, heatTexels } from '../../web/view/heat';

const luminance = ([r, g, b]: readonly number[]): number => 0.2126 * r! + 0.7152 * g! + 0.0722 * b!;

describe('the heat map', () => {
  test('grows brighter from its lower end to the middle and darker from there, without a step back', () => {
    const light = Array.from({ length: 101 }, (_, i) => luminance(heatColour(i / 100)));
    for (let i = 1; i <= 50; i++) expect(light[i]!).toBeGreaterThan(light[i - 1]!);
    for (let i = 51; i <= 100; i++) expect(light[i]!).toBeLessThan(light[i - 1]!);
  });

  test('is blue below, red above, pale in the middle, and clamps', () => {
    const [cold, middle, warm] = [heatColour(0), heatColour(0.5), heatColour(1)];
    expect(cold[2]).toBeGreaterThan(2 * cold[0]);
    expect(warm[0]).toBeGreaterThan(2 * warm[2]);
    expect(Math.max(...middle) - Math.min(...middle)).toBeLessThan(0.06);
    expect(heatColour(-3)).toEqual(cold);
    expect(heatColour(7)).toEqual(warm);
  });

  test('has the same colours in the legend as in the texture', () => {
    const legend = heatGradient(256).map((css) => css.match(/\d+/g)!.map(Number));
    const texels = heatTexels(256);
    legend.forEach((rgb, i) => {
      expect(rgb).toEqual([...texels.subarray(4 * i, 4 * i + 3)]);
    });
  });
});
