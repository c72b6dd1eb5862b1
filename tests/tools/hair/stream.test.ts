import { expect, test } from 'vitest';
import { gap } from '../../../web/tools/geometry';
import { StreamTool } from '../../../web/tools/hair/stream-tool';
import { Chair, RADIUS } from './chair';

test('a stroke on the head becomes a stream that lies on the head', () => {
  const chair = new Chair();
  chair.stroke(new StreamTool(chair), [-10, 80], [0, 20], [10, -40]);
  expect(chair.commits).toEqual(['add-stream']);
  expect(chair.selected).toBe(0);
  const { points, fade } = chair.step.streams[0]!;
  expect(fade).toBe(false);
  expect(points.length).toBeGreaterThan(8);
  for (const point of points) expect(Math.abs(gap(point, [0, 0, 0]) - RADIUS)).toBeLessThan(2);
});

test('off the head a stream keeps the depth at which it left it', () => {
  const chair = new Chair();
  chair.stroke(new StreamTool(chair), [60, 0], [97, 0], [180, -30]);
  const beyond = chair.step.streams[0]!.points.filter(([x]) => x > 120);
  expect(beyond.length).toBeGreaterThan(3);
  const depths = beyond.map(([, , z]) => z);
  expect(Math.max(...depths) - Math.min(...depths)).toBeLessThan(0.02);
  expect(depths[0]!).toBeLessThan(40);
});

test('the hair can follow while the stroke is drawn, and Escape leaves no trace', () => {
  const chair = new Chair();
  const before = chair.step;
  const tool = new StreamTool(chair);
  tool.down(chair.sample([0, 50]));
  for (let y = 50; y > -50; y -= 4) tool.move([chair.sample([0, y])]);
  expect(chair.previewed!.step.streams).toHaveLength(1);
  expect(chair.shown!.line.length).toBeGreaterThan(10);
  tool.cancel();
  expect(chair.previewed).toBeNull();
  expect(chair.shown).toBeNull();
  expect(chair.step).toBe(before);
  expect(chair.commits).toEqual([]);
});

test('a click, and a stroke hardly longer, say what a stroke needs and change nothing', () => {
  const chair = new Chair();
  const tool = new StreamTool(chair);
  chair.stroke(tool, [0, 0]);
  chair.stroke(tool, [0, 0], [3, 3]);
  expect(chair.remarks).toEqual(['too-short', 'too-short']);
  expect(chair.step.streams).toEqual([]);
  expect(chair.commits).toEqual([]);
});

test('a press beside the head is left to the camera, and the pointer says so before', () => {
  const chair = new Chair();
  const tool = new StreamTool(chair);
  tool.hover(chair.sample([150, 0]));
  expect(chair.aimed).toBe(false);
  expect(chair.stroke(tool, [150, 0], [180, 40])).toBe(false);
  tool.hover(chair.sample([50, 0]));
  expect(chair.aimed).toBe(true);
});

test('a stroke that crosses itself is a stream like any other', () => {
  const chair = new Chair();
  chair.stroke(new StreamTool(chair), [-40, 0], [40, 0], [40, 40], [0, 40], [0, -60]);
  expect(chair.step.streams[0]!.points.length).toBeGreaterThan(10);
});

test('with the mirror on a stream comes with its exact image, one along the middle comes alone', () => {
  const chair = new Chair();
  chair.mirror = true;
  chair.stroke(new StreamTool(chair), [20, 60], [70, -20]);
  const [own, image] = chair.step.streams;
  expect(image!.points).toEqual(own!.points.map(([x, y, z]) => [-x, y, z]));
  expect(chair.selected).toBe(0);
  chair.stroke(new StreamTool(chair), [2, 60], [3, -60]);
  expect(chair.step.streams).toHaveLength(3);
  expect(chair.step.streams[2]!.points.every(([x]) => x === 0)).toBe(true);
});
