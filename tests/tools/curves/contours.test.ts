import { beforeEach, expect, test, vi } from 'vitest';
import { ContourTool } from '../../../web/tools/curves/contours/contour-tool';
import type { ContoursHost } from '../../../web/tools/curves/contours/host';
import {
  arcUnder,
  controlsOf,
  curveOf,
  heldBeside,
  type PickedLine,
  partOf,
  pickedFrom,
  pickedOf,
  spanAround,
  trimmedAt,
} from '../../../web/tools/curves/contours/picked';
import { splinePoints } from '../../../web/tools/curves/spline';
import { type Line, lengthOf, nearestOn } from '../../../web/tools/stroke/polyline';
import type { PenHit, PenPart } from '../../../web/view/overlays/types';
import type { PointerSample, Vec3 } from '../../../web/view/types';

const SIZE = 2;
const straight = (y: number, from = 0, to = 1, count = 41): Vec3[] =>
  Array.from({ length: count }, (_, i) => [from + ((to - from) * i) / (count - 1), y, 0]);
const arc = (radius: number, degrees: number, count = 80): Vec3[] =>
  Array.from({ length: count }, (_, i) => {
    const a = (degrees * Math.PI * i) / (count - 1) / 180;
    return [radius * Math.cos(a), radius * Math.sin(a), 0];
  });
function drawingOf(lines: readonly Line[], closed = lines.map(() => 0)) {
  const offsets = [0];
  for (const line of lines) offsets.push(offsets.at(-1)! + line.length);
  return {
    points: Float64Array.from(lines.flatMap((line) => line.flatMap((point) => [...point]))),
    offsets: Uint32Array.from(offsets),
    closed: Uint8Array.from(closed),
  };
}

test('a short line is taken up whole, of a long one what is around the click', () => {
  expect(spanAround(1, 0.2, 0.4)).toEqual([0, 1]);
  expect(spanAround(10, 5, 1)).toEqual([4, 6]);
  expect(spanAround(10, 0.2, 1)).toEqual([0, 2]);
  expect(spanAround(10, 10, 1)).toEqual([8, 10]);
});

test('a piece of a line begins and ends where it was asked to', () => {
  const line = straight(0);
  const part = partOf(line, [0.33, 0.71]);
  expect(part[0]![0]).toBeCloseTo(0.33, 12);
  expect(part.at(-1)![0]).toBeCloseTo(0.71, 12);
  expect(lengthOf(part)).toBeCloseTo(0.38, 12);
  expect(lengthOf(partOf(line, [0, 1]))).toBeCloseTo(1, 12);
  expect(lengthOf(partOf(line, [0.25, 0.5]))).toBeCloseTo(0.25, 12);
});

test('an end goes along the line, not beyond it, and not past the other end', () => {
  const picked: PickedLine = { line: straight(0), span: [0.2, 0.8], reach: 0.1, others: [] };
  expect(trimmedAt(picked, 'start', 0.5, SIZE)).toEqual([0.5, 0.8]);
  expect(trimmedAt(picked, 'start', -1, SIZE)).toEqual([0, 0.8]);
  expect(trimmedAt(picked, 'end', 7, SIZE)[1]).toBeCloseTo(1, 12);
  const [from, to] = trimmedAt(picked, 'start', 0.9, SIZE);
  expect(from).toBeLessThan(to);
  expect(trimmedAt(picked, 'end', 0, SIZE)[1]).toBeGreaterThan(0.2);
});

test('the pointer is told by the line as it is seen, in places on the line as it is', () => {
  const line = straight(0);
  const seen = line.map(([x]) => ({ x: 100 + 200 * x, y: 50 }));
  expect(arcUnder(line, seen, 150, 60)).toBeCloseTo(0.25, 9);
  expect(arcUnder(line, seen, 0, 50)).toBe(0);
  expect(arcUnder(line, seen, 900, 50)).toBeCloseTo(1, 9);
});

test('a straight line is two control points, a bent one as many as keep to it', () => {
  expect(controlsOf(straight(0), 0.01, 24)).toHaveLength(2);
  const bent = arc(1, 150);
  const controls = controlsOf(bent, 0.004, 24);
  expect(controls.length).toBeGreaterThan(3);
  expect(controls.length).toBeLessThan(14);
  const curve = splinePoints(controls);
  for (const point of bent) expect(nearestOn(curve, point)!.distance).toBeLessThan(0.005);
  expect(controlsOf(bent, 0, 9)).toHaveLength(9);
});

test('other lines hold where they are within reach, but for what touches', () => {
  const part = straight(0);
  const beside = straight(0.1);
  const across: Vec3[] = Array.from({ length: 61 }, (_, i) => [0.5, i / 50, 0]);
  const far = straight(0.9);
  const held = heldBeside(part, [far, across, beside], 0.4, SIZE);
  expect(held).toHaveLength(2);
  const [first, second] = held as [Vec3[], Vec3[]];
  // The line that crosses holds from a little off the crossing to the end of the reach.
  expect([first, second].find((line) => line[0]![1] !== 0.1)!.at(-1)![1]).toBeCloseTo(0.4, 1);
  const touching = [first, second].find((line) => line.some(([, y]) => y > 0.2))!;
  expect(Math.min(...touching.map(([, y]) => y))).toBeGreaterThan(0.05);
});

test('a picked line is a contour of the recipe, and in hand again from there', () => {
  const drawing = drawingOf([straight(0), straight(0.15), straight(3)]);
  const picked = pickedFrom(drawing, { line: 0, segment: 20, point: [0.5, 0, 0] }, 0.2, SIZE);
  expect(picked.span[1] - picked.span[0]).toBeCloseTo(0.6, 6);
  expect(picked.others).toHaveLength(2);
  const curve = curveOf(picked, 'line 1', true, SIZE);
  expect(curve).toMatchObject({ id: 'line 1', kind: 'contour', reach: 0.2 });
  expect(curve.held).toHaveLength(1);
  expect(curveOf(picked, 'line 1', false, SIZE).held).toBeUndefined();
  const again = pickedOf(curve, 1);
  expect(again.reach).toBe(0.2);
  expect(again.span[0]).toBe(0);
  expect(again.span[1]).toBeCloseTo(0.6, 3);
});

test('a ring is opened across from where it was picked', () => {
  const ring = arc(1, 351, 40);
  const picked = pickedFrom(drawingOf([ring], [1]), { line: 0, segment: 0, point: ring[0]! }, 0.2, SIZE);
  expect(lengthOf(picked.line)).toBeCloseTo(2 * Math.PI, 0);
  const middle = partOf(picked.line, picked.span);
  expect(nearestOn(middle, ring[0]!)!.distance).toBeLessThan(0.02);
  const whole = lengthOf(picked.line);
  expect(picked.span[0]).toBeGreaterThan(0.2 * whole);
  expect(picked.span[1]).toBeLessThan(0.8 * whole);
});

/** Looks along −z; a model unit is a hundred pixels. */
class Table implements ContoursHost {
  part: PenPart | null = null;
  hits: PenHit[] = [];
  /** Of the surface in front of what is looked at. */
  depth: number | null = null;
  picked: PickedLine | null = null;
  readonly size = SIZE;
  readonly view = {
    camera: { position: [0, 0, 10] as const, target: [0, 0, 0] as const, orthographic: true },
    pick: (x: number, y: number) =>
      this.depth === null
        ? null
        : {
            point: [x / 100, y / 100, this.depth] as const,
            normal: [0, 0, 1] as const,
            triangle: 0,
            vertex: 0,
            distance: 1,
          },
    project: ([x, y]: Vec3) => ({ x: 100 * x, y: 100 * y, behind: false }),
    pixelSize: () => 0.01,
    pointOnScreenPlane: (x: number, y: number): Vec3 => [x / 100, y / 100, 0],
  };
  readonly pen = { pickLines: () => this.hits, pickHold: () => this.part };
  held = () => this.picked && { picked: this.picked, shift: [0, 0, 0] as const, line: this.picked.line };
  hover = vi.fn();
  pickUp = vi.fn(() => {
    this.picked = { line: straight(0), span: [0, 1], reach: 0.2, others: [] };
  });
  trim = vi.fn();
  reach = vi.fn();
  settle = vi.fn();
  pull = vi.fn();
  release = vi.fn();
  cancel = vi.fn();
}

const HIT: PenHit = { line: 3, segment: 1, t: 0.5, point: [0.5, 0, 0], distance: 2 };
const at = (x: number, y: number, button = 0): PointerSample => ({
  x,
  y,
  button,
  pressure: 0.5,
  pointerType: 'mouse',
  shift: false,
  alt: false,
  ctrl: false,
  hit: null,
});

let table: Table;
let tool: ContourTool;
beforeEach(() => {
  table = new Table();
  tool = new ContourTool(table);
});

test('a click picks a line up, a press beside all lines leaves the pointer to the camera', () => {
  expect(tool.down(at(50, 0))).toBe(false);
  table.hits = [HIT];
  expect(tool.down(at(50, 0))).toBe(true);
  tool.up(at(51, 0));
  expect(table.pickUp).toHaveBeenCalledWith(HIT);
  expect(table.pull).not.toHaveBeenCalled();
  expect(tool.down(at(50, 0, 2))).toBe(false);
});

test('a line behind the surface is not met', () => {
  table.hits = [HIT, { ...HIT, line: 4, point: [0.5, 0, 1] }];
  table.depth = 1;
  tool.hover(at(50, 0));
  expect(table.hover).toHaveBeenLastCalledWith(4, null);
  table.depth = 0.01;
  tool.hover(at(50, 0));
  expect(table.hover).toHaveBeenLastCalledWith(3, null);
});

test('a drag picks a line up and pulls it by as much as the pointer moves', () => {
  table.hits = [HIT];
  tool.down(at(50, 0));
  tool.move([at(51, 1)]);
  expect(table.pickUp).not.toHaveBeenCalled();
  tool.move([at(60, -20)]);
  expect(table.pickUp).toHaveBeenCalledTimes(1);
  const [by] = table.pull.mock.lastCall as [Vec3];
  expect(by[0]).toBeCloseTo(0.1, 12);
  expect(by[1]).toBeCloseTo(-0.2, 12);
  tool.up(at(60, -20));
  expect(table.release).toHaveBeenCalledTimes(1);
});

test('an end is trimmed, the ring sets the reach, and Escape takes either back', () => {
  table.pickUp();
  table.part = 'end';
  tool.down(at(100, 0));
  tool.move([at(70, 8)]);
  const [span] = table.trim.mock.lastCall as [readonly [number, number]];
  expect(span[0]).toBe(0);
  expect(span[1]).toBeCloseTo(0.7, 9);
  tool.up(at(70, 8));
  expect(table.settle).toHaveBeenCalledTimes(1);
  table.part = 'ring';
  tool.down(at(70, 0));
  tool.move([at(50, 40)]);
  expect((table.reach.mock.lastCall as [number])[0]).toBeCloseTo(0.4, 12);
  tool.move([at(50, 4000)]);
  expect((table.reach.mock.lastCall as [number])[0]).toBe(SIZE);
  tool.cancel();
  expect(table.cancel).toHaveBeenCalledTimes(1);
  expect(table.release).not.toHaveBeenCalled();
});

test('a click on the line in hand pulls nothing', () => {
  table.pickUp();
  table.part = 'line';
  tool.down(at(50, 0));
  tool.up(at(51, 1));
  expect(table.pull).not.toHaveBeenCalled();
  expect(table.release).not.toHaveBeenCalled();
});
