import { expect, test } from 'vitest';
import type { DeformHandle } from '../../web/recipe/recipe';
import { GizmoDrag, gizmoFrame } from '../../web/tools/deform/gizmo-drag';
import { PointTool } from '../../web/tools/deform/point-tool';
import { SelectTool } from '../../web/tools/deform/select-tool';
import { compose, IDENTITY, multiply, transform, translation } from '../../web/tools/geometry';
import { at, Table } from './table';

const corner: DeformHandle = {
  kind: 'region',
  vertices: [at(0, 0), at(1, 0), at(0, 1), at(1, 1)],
  matrix: [...IDENTITY],
  name: 'Corner',
};
const pin: DeformHandle = { kind: 'point', vertices: [at(10, 10)], position: [10, 10, 0], name: 'Pin' };

test('a click selects the handle under the pointer and edits nothing', () => {
  const table = new Table({ handles: [corner, pin] });
  const before = table.step;
  expect(table.click(new SelectTool(table), 1, 1)).toBe(true);
  expect(table.selected).toBe(0);
  expect(table.step).toBe(before);
});

test('dragging a handle moves it by the way of the pointer, in one step of undo', () => {
  const table = new Table({ handles: [corner, pin] });
  table.stroke(new SelectTool(table), [
    [1, 1],
    [4, 1],
    [8, 6],
  ]);
  expect(table.step.handles[0]).toMatchObject({ matrix: [...translation([7, 5, 0])] });
  expect(table.step.handles[1]).toBe(pin);
  expect(table.commits).toEqual(['move-handle']);
  expect(table.selected).toBe(0);
});

test('a second drag adds to the first', () => {
  const table = new Table({ handles: [corner] });
  const tool = new SelectTool(table);
  const drag: [number, number][] = [
    [1, 1],
    [6, 1],
  ];
  table.stroke(tool, drag);
  table.stroke(tool, drag);
  expect(table.step.handles[0]).toMatchObject({ matrix: [...translation([10, 0, 0])] });
});

test('a move of two pixels is still a click', () => {
  const table = new Table({ handles: [corner] });
  table.stroke(new SelectTool(table), [
    [1, 1],
    [2, 2],
  ]);
  expect(table.commits).toEqual([]);
  expect(table.selected).toBe(0);
});

test('Escape while dragging leaves no trace, and the release after it does nothing', () => {
  const table = new Table({ handles: [corner] });
  const before = table.step;
  const tool = new SelectTool(table);
  tool.down(table.sample(1, 1));
  tool.move([table.sample(9, 9)]);
  expect(table.previewed).not.toBeNull();
  tool.cancel();
  tool.up(table.sample(9, 9));
  expect(table.previewed).toBeNull();
  expect(table.step).toBe(before);
  expect(table.commits).toEqual([]);
});

test('a point handle is taken by its marker', () => {
  const table = new Table({ handles: [corner, pin] });
  table.stroke(new SelectTool(table), [
    [10, 10],
    [10, 16],
  ]);
  expect(table.step.handles[1]).toMatchObject({ position: [10, 16, 0] });
});

test('a hidden handle cannot be grabbed', () => {
  const table = new Table({ handles: [{ ...corner, hidden: true }] });
  expect(table.click(new SelectTool(table), 1, 1)).toBe(false);
});

test('a press on bare surface belongs to the camera', () => {
  const table = new Table({ handles: [corner] });
  expect(table.click(new SelectTool(table), 15, 15)).toBe(false);
});

test('Shift+click places a point handle', () => {
  const table = new Table({ handles: [corner] });
  table.click(new SelectTool(table), 15, 15, { shift: true });
  expect(table.step.handles[1]).toMatchObject({
    kind: 'point',
    vertices: [at(15, 15)],
    position: [15, 15, 0],
  });
  expect(table.selected).toBe(1);
  expect(table.commits).toEqual(['add-point']);
});

test('the point tool places and drags in one step of undo', () => {
  const table = new Table();
  table.stroke(new PointTool(table), [
    [5, 5],
    [5, 12],
  ]);
  expect(table.step.handles[0]).toMatchObject({ vertices: [at(5, 5)], position: [5, 12, 0] });
  expect(table.commits).toEqual(['add-point']);
});

test('the point tool drags a handle that is already there', () => {
  const table = new Table({ handles: [pin] });
  table.stroke(new PointTool(table), [
    [10, 10],
    [16, 10],
  ]);
  expect(table.step.handles).toHaveLength(1);
  expect(table.commits).toEqual(['move-handle']);
});

test('the gizmo turns a handle about its own middle', () => {
  const table = new Table({ handles: [corner] });
  table.selected = 0;
  const gizmo = new GizmoDrag(table, () => 'rotate');
  const frame = gizmoFrame(corner, table.rest);
  const turn = compose({ translation: [0, 0, 0], rotation: [0, 0, 90], scale: [1, 1, 1] }, [0, 0, 0]);
  gizmo.onStart();
  gizmo.onChange(multiply(frame, turn));
  gizmo.onEnd();
  const turned = table.step.handles[0] as Extract<DeformHandle, { kind: 'region' }>;
  expect(transform(turned.matrix, [0.5, 0.5, 0])).toEqual([0.5, 0.5, 0]);
  expect(transform(turned.matrix, [1, 0, 0])).toEqual([1, 1, 0]);
  expect(table.commits).toEqual(['rotate-handle']);
});

test('the gizmo scales along the axes the handle has been turned to', () => {
  const tilted = compose({ translation: [0, 0, 3], rotation: [0, 0, 90], scale: [1, 1, 1] }, [0.5, 0.5, 0]);
  const table = new Table({ handles: [{ ...corner, matrix: [...tilted] }] });
  table.selected = 0;
  const gizmo = new GizmoDrag(table, () => 'scale');
  const frame = gizmoFrame(table.step.handles[0]!, table.rest);
  gizmo.onStart();
  gizmo.onChange(multiply(frame, [2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]));
  gizmo.onEnd();
  const scaled = table.step.handles[0] as Extract<DeformHandle, { kind: 'region' }>;
  // The handle's own x axis points along y now: (1.5, 0.5) was half a unit along it, and is a whole one.
  expect(transform(scaled.matrix, [1, 0.5, 0])).toEqual([0.5, 1.5, 3]);
});

test('a gizmo that is put back where it was taken edits nothing', () => {
  const table = new Table({ handles: [corner] });
  table.selected = 0;
  const gizmo = new GizmoDrag(table, () => 'translate');
  const frame = gizmoFrame(corner, table.rest);
  gizmo.onStart();
  gizmo.onChange(multiply(translation([5, 0, 0]), frame));
  gizmo.onChange(frame.map((x) => x * (1 + 1e-15)));
  gizmo.onEnd();
  expect(table.commits).toEqual([]);
  expect(table.previewed).toBeNull();
});
