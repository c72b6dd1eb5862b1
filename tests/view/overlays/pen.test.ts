import { expect, test } from 'vitest';
import { ModelView } from '../../../web/view/model-view';
import { PEN_LINES } from '../../../web/view/overlays/pen-lines';
import { holdAt, linesNear } from '../../../web/view/overlays/pen-picking';
import { penStrokes } from '../../../web/view/overlays/pen-strokes';
import type { PenDrawing } from '../../../web/view/overlays/types';
import { leftBy, made } from '../card';

/** A line of three points and a closed one of four, on the screen where they are in the model. */
const POINTS = [...[0, 0, 1, 100, 0, 1, 200, 0, 1], ...[0, 50, 1, 100, 50, 1, 100, 150, 1, 0, 150, 1]];
const DRAWING = {
  points: Float64Array.from(POINTS),
  offsets: Uint32Array.of(0, 3, 7),
  suggestive: Uint8Array.of(0, 1),
  closed: Uint8Array.of(0, 1),
};
const SEEN = Float32Array.from(POINTS);

test('a line is met within eight pixels, with the place that was met; the nearer one first', () => {
  const [first, ...others] = linesNear(DRAWING, SEEN, 150, 6);
  expect(first).toMatchObject({ line: 0, segment: 1, t: 0.5, distance: 6 });
  expect(first!.point).toEqual([150, 0, 1]);
  expect(others).toEqual([]);
  expect(linesNear(DRAWING, SEEN, 150, 9)).toEqual([]);
  expect(linesNear(DRAWING, SEEN, 208.5, 0)).toEqual([]);
  const close = { ...DRAWING, points: DRAWING.points.map((x, i) => (i % 3 === 1 && i > 9 ? x - 44 : x)) };
  expect(linesNear(close, Float32Array.from(close.points), 50, 4).map(({ line }) => line)).toEqual([1, 0]);
});

test('a ring is met between its last point and its first, an open line is not', () => {
  expect(linesNear(DRAWING, SEEN, 2, 100)).toMatchObject([{ line: 1, segment: 3, t: 0.5 }]);
  expect(linesNear({ ...DRAWING, closed: Uint8Array.of(0, 0) }, SEEN, 2, 100)).toEqual([]);
});

test('what is behind the eye is not met', () => {
  const behind = SEEN.map((x, i) => (i === 5 ? -1 : x));
  expect(linesNear(DRAWING, behind, 50, 0)).toEqual([]);
});

test('of the line in hand ends win over the line, the line over the ring', () => {
  const line = [0, 50, 100].map((x) => ({ x, y: 0, z: 1 }));
  const at = (x: number, y: number) => holdAt(line, { x: 50, y: 0, z: 1 }, 60, x, y);
  expect([at(8, 0), at(95, 3), at(50, 7), at(50, 58), at(50, 30)]).toEqual([
    'start',
    'end',
    'line',
    'ring',
    null,
  ]);
});

test('contours are stronger than suggestive ones; open lines run out at both ends, rings do not', () => {
  const offsets = Uint32Array.of(0, 21, 42, 46);
  const places = new Float32Array(3 * 46);
  for (let i = 0; i < 42; i++) places.set([(i % 21) / 20, i < 21 ? 0 : 1, 0], 3 * i);
  [0, 1, 1, 0].forEach((x, i) => {
    places.set([x, i < 2 ? 2 : 3, 0], 3 * (42 + i));
  });
  const { ends, looks } = penStrokes(
    { offsets, suggestive: Uint8Array.of(0, 1, 1), closed: Uint8Array.of(0, 0, 1) },
    places,
    [0, 0, 0],
  );
  expect(looks.length / 4).toBe(20 + 20 + 4);
  expect(ends.length / 6).toBe(looks.length / 4);
  const width = (piece: number) => looks[4 * piece + 3]!;
  const paleness = (piece: number) => looks[4 * piece]!;
  expect(width(10)).toBeGreaterThan(width(30));
  expect(width(0)).toBeLessThan(0.6 * width(10));
  expect(width(19)).toBeCloseTo(width(0), 5);
  expect(paleness(0)).toBeGreaterThan(paleness(10));
  expect(new Set([40, 41, 42, 43].map(width)).size).toBe(1);
  expect([...ends.subarray(6 * 43)]).toEqual([0, 3, 0, 0, 2, 0]);
});

test('a line that was split at a corner does not run out there', () => {
  const strokes = (corner: number) =>
    penStrokes(
      { offsets: Uint32Array.of(0, 11, 22), suggestive: Uint8Array.of(0, 0), closed: Uint8Array.of(0, 0) },
      Float32Array.from([
        ...Array.from({ length: 11 }, (_, i) => [i / 10, 0, 0]).flat(),
        ...Array.from({ length: 11 }, (_, i) => [1, corner + i / 10, 0]).flat(),
      ]),
      [0, 0, 0],
    ).looks;
  const [joined, apart] = [strokes(0), strokes(0.01)];
  expect(joined[4 * 9 + 3]).toBe(joined[4 * 5 + 3]);
  expect(apart[4 * 9 + 3]).toBeLessThan(apart[4 * 5 + 3]!);
  expect(joined[3]).toBeLessThan(joined[4 * 5 + 3]!);
});

const view = () =>
  new ModelView({
    positions: Float64Array.of(0, 0, 0, 2, 0, 0, 0, 2, 0),
    triangles: Uint32Array.of(0, 1, 2),
    faceOffsets: Uint32Array.of(0, 3),
    faceVertices: Uint32Array.of(0, 1, 2),
    welded: Int32Array.of(0, 1, 2),
  });
const ACROSS: PenDrawing = {
  points: Float64Array.of(2, 0, 0, 0, 2, 0),
  offsets: Uint32Array.of(0, 2),
  corners: Uint32Array.of(0, 1, 2, 0, 1, 2),
  weights: Float32Array.of(0, 1, 0, 0, 0, 1),
  suggestive: Uint8Array.of(0),
  closed: Uint8Array.of(0),
};

test('the model is paper without ground, tinted by what would move, and clay again afterwards', () => {
  const layer = made(PEN_LINES);
  const model = view();
  layer.place(model.space, model);
  expect(layer.bare).toBe(true);
  expect(layer.shade?.finish).toContain('penPaper');
  layer.tint(Float32Array.of(0, 0.5, 1));
  expect([...model.geometry.getAttribute('pull').array]).toEqual([0, 0.5, 1]);
  layer.tint(Float32Array.of(0, 0.5));
  expect(model.geometry.hasAttribute('pull')).toBe(false);
  layer.setDrawing(ACROSS);
  layer.hold({
    line: [
      [0, 0, 0],
      [1, 0, 0],
    ],
    ring: { centre: [0, 0, 0], radius: 1 },
    lit: null,
  });
  expect(leftBy(layer)).toEqual([]);
});

test('lines go along with the surface, and lie where it lies', async () => {
  const { PerspectiveCamera } = await import('three');
  const layer = made(PEN_LINES);
  const model = view();
  layer.place(model.space, model);
  layer.resize?.(100, 100, 1);
  const camera = new PerspectiveCamera(30, 1, 0.1, 100);
  camera.position.z = 10;
  camera.updateMatrixWorld();
  layer.prepare?.(camera, 0);
  layer.setDrawing(ACROSS);
  const [before] = layer.pickLines(50, 50);
  expect(before!.point[0] + before!.point[1]).toBeCloseTo(2, 9);
  layer.carry(Float64Array.of(0, 0, 0, 2, 0, 1, 0, 2, 1));
  const [after] = layer.pickLines(50, 50);
  expect(after!.point[2]).toBeCloseTo(1, 6);
});
