import { beforeEach, expect, test } from 'vitest';
import { gap } from '../../../web/tools/geometry';
import { HairSelectTool, HintTool } from '../../../web/tools/hair/select-tool';
import { StreamTool } from '../../../web/tools/hair/stream-tool';
import { mirrored } from '../../../web/tools/hair/style';
import { lengthOf, nearestOn } from '../../../web/tools/stroke/polyline';
import { SupportSurface, viewpointOf } from '../../../web/tools/stroke/support';
import type { Vec3 } from '../../../web/view/types';
import { Chair } from './chair';

let chair: Chair;
let tool: HintTool;
let before: readonly Vec3[];

/** A stream straight down the middle of the face, selected. */
beforeEach(() => {
  chair = new Chair();
  tool = new HintTool(chair);
  chair.stroke(new StreamTool(chair), [0, 80], [0, -80]);
  before = chair.step.streams[0]!.points;
});

const after = () => chair.step.streams[0]!.points;

test('a long stroke across the curve cuts it there and leaves the part that grows from the head', () => {
  chair.stroke(tool, [-30, 0], [30, 2]);
  expect(chair.commits.at(-1)).toBe('cut');
  expect(after()[0]).toEqual(before[0]);
  expect(after().at(-1)![1]).toBeCloseTo(1, 1);
  expect(lengthOf(after())).toBeLessThan(0.6 * lengthOf(before));
});

test('a cut is not previewed: the stroke may yet become something else', () => {
  tool.down(chair.sample([-30, 0]));
  tool.move([chair.sample([30, 0])]);
  expect(chair.previewed).toBeNull();
  tool.cancel();
  expect(after()).toBe(before);
});

test('a stroke that starts near the curve and ends far away continues it from there', () => {
  chair.stroke(tool, [2, 0], [60, -20], [110, -60]);
  expect(chair.commits.at(-1)).toBe('concatenate');
  expect(after()[0]).toEqual(before[0]);
  const [x, y] = after().at(-1)!;
  expect([x, y].map((c) => Math.round(c))).toEqual([110, -60]);
  expect(nearestOn(after(), before[3]!)!.distance).toBeLessThan(0.01);
});

test('off the supporting surface the depth goes on as it went on it', () => {
  chair.stroke(tool, [2, -60], [44, -70], [100, -80]);
  const off = after().filter(([x]) => x > 50);
  expect(off.length).toBeGreaterThan(2);
  const steps = off.slice(1).map(([x, , z], i) => (z - off[i]![2]) / (x - off[i]![0]));
  // Points are kept to whole units on a head of 200.
  for (const step of steps) expect(Math.abs(step - steps[0]!)).toBeLessThan(0.2);
  expect(steps[0]!).toBeLessThan(0);
});

test('a stroke that starts and ends near the curve takes the place of what lies between', () => {
  chair.stroke(tool, [1, 40], [35, 20], [35, -20], [1, -40]);
  expect(chair.commits.at(-1)).toBe('insert');
  expect(after()[0]).toEqual(before[0]);
  expect(after().at(-1)).toEqual(before.at(-1));
  expect(Math.max(...after().map(([x]) => x))).toBeGreaterThan(30);
  const forwards = after();
  chair.step = { ...chair.step, streams: [{ points: [...before] as never, fade: false }] };
  chair.stroke(tool, [1, -40], [35, -20], [35, 20], [1, 40]);
  for (const point of after()) expect(nearestOn(forwards, point)!.distance).toBeLessThan(2);
});

test('a stroke that neither starts near the curve nor crosses it says so and changes nothing', () => {
  chair.stroke(tool, [22, 20], [40, -20]);
  expect(chair.remarks).toEqual(['not-a-hint']);
  expect(after()).toBe(before);
});

test('what would leave no curve is refused', () => {
  chair.stroke(tool, [-20, 78], [20, 78]);
  expect(chair.remarks).toEqual(['nothing-left']);
  expect(after()).toBe(before);
});

test('editing a curve often does not wear it down', () => {
  for (let i = 0; i < 6; i++) chair.stroke(tool, [1, -60], [30, -70], [60, -70]);
  for (const point of before.filter(([, y]) => y > -20))
    expect(nearestOn(after(), point)!.distance).toBeLessThan(0.01);
});

test('the strip faces the viewer, the ruled surface is seen edge on, and both pass through the curve', () => {
  const line: Vec3[] = [0, 1, 2, 3].map((i) => [i, Math.sin(i), 0.3 * i]);
  const camera = { position: [0, 0, 50], target: [0, 0, 0], orthographic: false } as const;
  for (const kind of ['strip', 'ruled'] as const) {
    const { positions } = new SupportSurface(line, viewpointOf(camera), kind, 2);
    line.forEach((point, i) => {
      const [a, b] = [0, 3].map((k) => [...positions.subarray(6 * i + k, 6 * i + k + 3)] as unknown as Vec3);
      expect(gap(point, [0, 1, 2].map((k) => (a![k]! + b![k]!) / 2) as unknown as Vec3)).toBeLessThan(1e-9);
      expect(gap(a!, b!)).toBeCloseTo(4, 9);
      const sight = [0, 1, 2].map((k) => point[k]! - camera.position[k]!);
      const ruling = [0, 1, 2].map((k) => b![k]! - a![k]!);
      const along = Math.abs(sight.reduce((sum, s, k) => sum + s * ruling[k]!, 0)) / Math.hypot(...sight) / 4;
      expect(along).toBeCloseTo(kind === 'strip' ? 0 : 1, 9);
    });
  }
});

test('seen from the side, a hint on the ruled surface changes the depth and not the picture from the front', () => {
  chair.kind = 'ruled';
  chair.side = 'right';
  chair.stroke(tool, [-before[4]![2] + 1, before[4]![1]], [-118, 0], [-118, -70]);
  expect(chair.commits.at(-1)).toBe('concatenate');
  expect(after().at(-1)![2]).toBeGreaterThan(110);
  for (const [x] of after()) expect(Math.abs(x)).toBeLessThan(0.02);
});

test('dragging a control point takes its neighbours along and leaves the root where it is', () => {
  const place = before[6]!;
  chair.stroke(new HairSelectTool(chair), [place[0], place[1]], [place[0] + 20, place[1]]);
  expect(chair.commits.at(-1)).toBe('move-point');
  expect(after()[6]![0]).toBeCloseTo(place[0] + 20, 1);
  expect(after()[5]![0]).toBeGreaterThan(5);
  expect(after()[0]).toEqual(before[0]);
  expect(after().at(-1)).toEqual(before.at(-1));
});

test('a click selects another curve, a click on nothing near the selected one lets go of it', () => {
  chair.stroke(new StreamTool(chair), [60, 40], [60, -40]);
  expect(chair.selected).toBe(1);
  for (const each of [tool, new HairSelectTool(chair)]) {
    chair.selected = 1;
    chair.stroke(each, [0, 3]);
    expect(chair.selected).toBe(0);
  }
  chair.stroke(tool, [25, 10]);
  expect(chair.selected).toBeNull();
  expect(chair.stroke(tool, [25, 10], [30, 30])).toBe(false);
});

test('with the mirror on, the twin of an edited curve stays its twin', () => {
  chair.mirror = true;
  chair.stroke(new StreamTool(chair), [60, 40], [60, -40]);
  chair.stroke(tool, [61, -30], [90, -60], [95, -100]);
  const [, own, twin] = chair.step.streams;
  expect(chair.commits.at(-1)).toBe('concatenate');
  expect(mirrored({ kind: 'stream', item: own! }).item).toEqual(twin);
});
