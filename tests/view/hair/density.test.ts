import { expect, test } from 'vitest';
import { bakeLight } from '../../../web/view/hair/baked-light';
import { DensityGrid } from '../../../web/view/hair/density';
import { resample } from '../../../web/view/hair/resample';
import { ViewSpace } from '../../../web/view/view-space';
import { straight, strandsOf } from './strands';

const LOW = [-1, -1, -1] as const;
const HIGH = [1, 1, 1] as const;

const sum = (values: Float32Array): number => values.reduce((total, value) => total + value, 0);

/** A bundle of upright strands on a square lattice. */
const bundle = (side: number) =>
  resample(
    strandsOf(
      Array.from({ length: side * side }, (_, s) => {
        const x = ((s % side) / (side - 1) - 0.5) * 0.8;
        const z = (Math.floor(s / side) / (side - 1) - 0.5) * 0.8;
        return straight([x, 0.4, z], [x, -0.4, z], 9);
      }),
    ),
    ViewSpace.identity,
  );

test('the grid holds the covered area of all strands, however many stand for them', () => {
  const strands = bundle(20);
  for (const most of [400, 100]) {
    const grid = new DensityGrid(LOW, HIGH, 24);
    grid.addStrands(strands, 0.01, most);
    expect(sum(grid.extinction) * grid.cell ** 3).toBeCloseTo((Math.PI / 4) * 400 * 0.8 * 0.01, 4);
  }
});

test('the grid holds the area of a surface, whatever the size of its triangles', () => {
  const grid = new DensityGrid(LOW, HIGH, 24);
  grid.addSurface([-0.7, 0, -0.5, 0.7, 0, -0.5, 0, 0, 0.6], [0, 1, 2], 2);
  expect(sum(grid.extinction) * grid.cell ** 3).toBeCloseTo(2 * 0.5 * 1.4 * 1.1, 4);
});

test('smoothing moves nothing out of the grid', () => {
  const grid = new DensityGrid(LOW, HIGH, 24);
  grid.addStrands(bundle(8), 0.01);
  const before = sum(grid.extinction);
  grid.smooth();
  expect(sum(grid.extinction)).toBeCloseTo(before, 2);
});

test('through an even block the depth is the way times the extinction, from any side', () => {
  const grid = new DensityGrid(LOW, HIGH, 21);
  grid.extinction.fill(0.7);
  const middle = 10 + 21 * (10 + 21 * 10);
  for (const axis of [0, 1, 2]) {
    for (const sign of [-1, 1]) {
      const direction = [0, 0, 0] as [number, number, number];
      direction[axis] = sign;
      // Ten steps and the half cell on the border, where depth starts.
      expect(grid.depthTowards(direction)[middle]!).toBeCloseTo(0.7 * grid.cell * 10.5, 4);
    }
  }
  const slanted = grid.depthTowards([1, 2, 0])[middle]!;
  // Leaves through the top after 10.5 cells of height.
  expect(slanted).toBeGreaterThan(0.7 * grid.cell * 10.5);
  expect(slanted).toBeLessThanOrEqual(0.7 * grid.cell * 10.5 * Math.hypot(0.5, 1) + 1e-4);
});

test('what lies behind the light is dark, what lies before it is not', () => {
  const grid = new DensityGrid(LOW, HIGH, 24);
  grid.addSurface([-1, 0, -1, 1, 0, -1, 0, 0, 1], [0, 1, 2], 5);
  const depth = grid.depthTowards([0, 1, 0]);
  const cell = (y: number): number => depth[12 + 24 * (y + 24 * 9)]!;
  expect(cell(18)).toBe(0);
  expect(cell(4)).toBeCloseTo(5, 0);
});

test('the inside of a bundle is darker than its outside, and more hair is darker still', () => {
  const middle = (side: number): number => {
    const { light, n } = bakeLight(bundle(side), 0.01, 1, undefined);
    return light[4 * (n / 2 + n * (n / 2 + n * (n / 2)))]!;
  };
  const { light } = bakeLight(bundle(20), 0.01, 1, undefined);
  expect(middle(20)).toBeLessThan(0.7 * light[0]!);
  expect(middle(40)).toBeLessThan(middle(20));
});
