import { expect, test } from 'vitest';
import { toIndices } from '../../web/core/vertex-set';
import { paintHandle, paintRoi } from '../../web/tools/deform/paint-tool';
import { Mirror } from '../../web/tools/mirror';
import { at, SIDE, sheet, Table } from './table';

const all = SIDE * SIDE;
const roi = (table: Table) => [...toIndices(table.step.roi, all)];
const handle = (table: Table, i: number) => [...toIndices(table.step.handles[i]!.vertices, all)];

test('a fast stroke of two far samples leaves no gap', () => {
  const table = new Table();
  table.stroke(paintRoi(table), [
    [2, 10],
    [18, 10],
  ]);
  for (let x = 2; x <= 18; x++) expect(roi(table)).toContain(at(x, 10));
  expect(table.commits).toEqual(['paint-roi']);
});

test('the first stroke replaces "everything", and later ones add', () => {
  const table = new Table();
  const tool = paintRoi(table);
  table.click(tool, 5, 5);
  table.click(tool, 15, 15);
  expect(roi(table)).toContain(at(5, 5));
  expect(roi(table)).toContain(at(15, 15));
  expect(roi(table)).not.toContain(at(10, 10));
});

test('Alt takes away, even from everything', () => {
  const table = new Table();
  table.click(paintRoi(table), 10, 10, { alt: true });
  expect(roi(table)).not.toContain(at(10, 10));
  expect(roi(table)).toContain(at(0, 0));
  expect(table.commits).toEqual(['erase-roi']);
});

test('Alt turns the erase switch around', () => {
  const table = new Table({ roi: [] });
  table.erase = true;
  table.click(paintRoi(table), 10, 10, { alt: true });
  expect(roi(table)).toContain(at(10, 10));
});

test('Shift+click fills up to the painted border', () => {
  const ring: [number, number][] = [];
  for (let i = 5; i <= 15; i++) ring.push([i, 5], [i, 15], [5, i], [15, i]);
  const table = new Table({ roi: ring.map(([x, y]) => at(x, y)) });
  table.click(paintRoi(table), 10, 10, { shift: true });
  // A diagonal of the sheet's triangles may not leak through the ring.
  expect(roi(table)).toHaveLength(11 * 11);
  expect(table.commits).toEqual(['fill-roi']);
});

test('Escape in the middle of a stroke leaves no trace', () => {
  const table = new Table();
  const before = table.step;
  const tool = paintRoi(table);
  tool.down(table.sample(5, 5));
  tool.move([table.sample(9, 5)]);
  expect(table.painted?.vertices.length).toBeGreaterThan(0);
  tool.cancel();
  tool.up(table.sample(9, 5));
  expect(table.step).toBe(before);
  expect(table.painted).toBeNull();
  expect(table.commits).toEqual([]);
});

test('a press beside the model is left to the camera', () => {
  const table = new Table();
  expect(table.click(paintRoi(table), -5, 5)).toBe(false);
});

test('a stroke that changes nothing is no step of undo', () => {
  const table = new Table({ roi: [at(10, 10)] });
  table.radius = 0.2;
  table.click(paintRoi(table), 10, 10);
  expect(table.commits).toEqual([]);
});

test('a brush smaller than a triangle paints the nearest vertex', () => {
  const table = new Table();
  table.radius = 0.01;
  table.click(paintRoi(table), 7.3, 7.2);
  expect(roi(table)).toEqual([at(7, 7)]);
});

test('a pen pressed harder paints wider', () => {
  const painted = [0, 1].map((pressure) => {
    const table = new Table();
    table.radius = 3;
    table.click(paintRoi(table), 10, 10, { pointerType: 'pen', pressure });
    return roi(table).length;
  });
  expect(painted[1]).toBeGreaterThan(painted[0]!);
});

test('the first stroke makes a handle and selects it, one that begins on it extends it', () => {
  const table = new Table();
  const tool = paintHandle(table);
  table.click(tool, 5, 5);
  table.stroke(tool, [
    [7, 5],
    [9, 5],
  ]);
  expect(table.step.handles).toHaveLength(1);
  expect(table.selected).toBe(0);
  expect(table.step.handles[0]).toMatchObject({ kind: 'region', name: 'Handle 1' });
  expect(handle(table, 0)).toEqual(expect.arrayContaining([at(5, 5), at(9, 5)]));
});

test('a stroke that begins elsewhere makes another handle', () => {
  const table = new Table();
  const tool = paintHandle(table);
  table.click(tool, 5, 5);
  table.click(tool, 15, 15);
  expect(table.step.handles.map(({ name }) => name)).toEqual(['Handle 1', 'Handle 2']);
  expect(table.selected).toBe(1);
});

test('a vertex belongs to one handle only, and a handle that is painted over goes', () => {
  const table = new Table();
  const tool = paintHandle(table);
  table.click(tool, 5, 5);
  table.radius = 4;
  table.stroke(tool, [
    [15, 5],
    [5, 5],
  ]);
  expect(table.step.handles).toHaveLength(1);
  expect(table.selected).toBe(0);
  expect(table.step.handles[0]!.name).toBe('Handle 2');
});

test('erasing all of a handle removes it', () => {
  const table = new Table();
  const tool = paintHandle(table);
  table.click(tool, 5, 5);
  table.radius = 3;
  table.click(tool, 5, 5, { alt: true });
  expect(table.step.handles).toEqual([]);
  expect(table.selected).toBeNull();
});

test('a handle painted on a moved surface starts where the surface is', () => {
  const table = new Table();
  const { positions } = sheet();
  table.posed = positions.map((x, i) => (i % 3 === 2 ? x + 4 : x));
  table.click(paintHandle(table), 5, 5);
  expect(table.step.handles[0]).toMatchObject({
    matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 4, 1].map((x) => expect.closeTo(x, 12)),
  });
});

test('on a surface at rest a new handle has exactly the identity', () => {
  const table = new Table();
  table.click(paintHandle(table), 5, 5);
  expect(table.step.handles[0]).toMatchObject({ matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] });
});

test('mirroring paints the other side of x = 0 too', () => {
  const table = new Table();
  const centred = table.rest.map((x, i) => (i % 3 === 0 ? x - 10 : x));
  const mirror = new Mirror(centred);
  table.mirrored = (set) => mirror.both(set);
  table.click(paintRoi(table), 3, 8);
  expect(roi(table)).toContain(at(3, 8));
  expect(roi(table)).toContain(at(17, 8));
  expect(roi(table)).not.toContain(at(10, 8));
});

test('the brush ring says whether it erases', () => {
  const table = new Table();
  const tool = paintRoi(table);
  tool.hover(table.sample(5, 5, { alt: true }));
  expect(table.brushShown).toMatchObject({ erase: true, radius: 1.5 });
  tool.leave();
  expect(table.brushShown).toBeNull();
});
