import { expect, test } from 'vitest';
import { gap } from '../../../web/tools/geometry';
import { PartingTool } from '../../../web/tools/hair/parting-tool';
import { HintTool } from '../../../web/tools/hair/select-tool';
import { tiltedBy } from '../../../web/tools/hair/tilt';
import type { Vec3 } from '../../../web/view/types';
import { Chair, RADIUS } from './chair';

test('a parting stays on the skin: what runs beyond the head is left out', () => {
  const chair = new Chair();
  chair.stroke(new PartingTool(chair), [0, 0], [0, 140]);
  expect(chair.commits).toEqual(['add-parting']);
  const { points, tilt, sigma, height } = chair.step.partings[0]!;
  expect({ tilt, sigma, height }).toEqual({ tilt: [0, 0], sigma: 1, height: 0.5 });
  for (const point of points) expect(Math.abs(gap(point, [0, 0, 0]) - RADIUS)).toBeLessThan(2);
  expect(points.at(-1)![1]).toBeGreaterThan(95);
});

test('a parting of one point says what it needs', () => {
  const chair = new Chair();
  chair.stroke(new PartingTool(chair), [0, 0]);
  expect(chair.remarks).toEqual(['too-short']);
  expect(chair.step.partings).toEqual([]);
});

const line: [number, number, number][] = [0, 1, 2, 3, 4].map((y) => [0, y, 0]);
const up: Vec3 = [0, 0, 1];
const leaning = (degrees: number): Vec3 => [
  Math.cos((degrees * Math.PI) / 180),
  Math.sin((degrees * Math.PI) / 180),
  0,
];

test('hair straight away from the parting has no tilt, whichever side the hint is on', () => {
  for (const side of [1, -1])
    expect(tiltedBy({ points: line, tilt: [0, 0] }, [0, 1, 0], [side, 0, 0], up)).toEqual([0, 0]);
});

test('the interpolated tilt is the hint’s where the hint is; the end further away keeps its own', () => {
  const [a, b] = tiltedBy({ points: line, tilt: [0, 8] }, [0, 1, 0], leaning(30), up);
  expect(b).toBe(8);
  expect(0.75 * a + 0.25 * b).toBeCloseTo(30, 0);
  const [c, d] = tiltedBy({ points: line, tilt: [a, b] }, [0, 4, 0], leaning(-20), up);
  expect([c, d]).toEqual([a, -20]);
});

test('the same hint drawn on the other side, turned about the normal by half a turn, gives the same tilt', () => {
  const one = tiltedBy({ points: line, tilt: [0, 0] }, [0, 0, 0], leaning(25), up);
  const [x, y, z] = leaning(25);
  expect(tiltedBy({ points: line, tilt: [0, 0] }, [0, 0, 0], [-x, -y, z], up)).toEqual(one);
});

test('hint strokes beside a drawn parting set its tilt at the end they are near, by either tool', () => {
  const chair = new Chair();
  const tool = new PartingTool(chair);
  chair.stroke(tool, [0, -60], [0, 60]);
  chair.stroke(tool, [2, -58], [30, -40]);
  const { tilt } = chair.step.partings[0]!;
  expect(tilt[1]).toBe(0);
  expect(Math.abs(tilt[0])).toBeGreaterThan(15);
  chair.stroke(new HintTool(chair), [-4, 50], [-35, 50]);
  expect(chair.commits).toEqual(['add-parting', 'tilt', 'tilt']);
  expect(Math.abs(chair.step.partings[0]!.tilt[1])).toBeLessThan(15);
  expect(chair.step.partings).toHaveLength(1);
});

test('a mirrored parting leans the other way round', () => {
  const chair = new Chair();
  chair.mirror = true;
  const tool = new PartingTool(chair);
  chair.stroke(tool, [40, -40], [40, 40]);
  expect(chair.step.partings).toHaveLength(2);
  chair.stroke(tool, [42, -38], [70, -20]);
  const [own, twin] = chair.step.partings;
  expect(own!.tilt[0]).not.toBe(0);
  expect(twin!.tilt).toEqual(own!.tilt.map((x) => -x + 0));
});
