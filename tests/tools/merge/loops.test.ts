import { expect, test } from 'vitest';
import { arcLengths, indexAt, openLoops } from '../../../web/tools/merge/loops';
import { sheet, soup } from './shapes';

/** Twice the area a loop goes around in the plane; above 0 counter-clockwise. */
function turn(loop: readonly number[], positions: Float64Array): number {
  return loop.reduce((sum, a, i) => {
    const b = loop[(i + 1) % loop.length]!;
    return sum + positions[3 * a]! * positions[3 * b + 1]! - positions[3 * b]! * positions[3 * a + 1]!;
  }, 0);
}

test('a sheet has one opening, its rim, with the surface to its left', () => {
  const { positions, ...surface } = sheet(4, 5);
  const [rim, ...others] = openLoops(surface);
  expect(others).toEqual([]);
  expect(rim).toHaveLength(2 * 3 + 2 * 4);
  expect(turn(rim!, positions)).toBe(2 * 3 * 4);
});

test('a hole is an opening too, run around the other way, and comes after the longer rim', () => {
  const { positions, ...surface } = sheet(7, 7, (x, y) => x === 3 && y === 3);
  const loops = openLoops(surface);
  expect(loops.map(({ length }) => length)).toEqual([24, 4]);
  expect(turn(loops[1]!, positions)).toBe(-2);
});

test('loose triangles of one place are one surface', () => {
  const whole = sheet(3, 3);
  const [rim] = openLoops(soup(whole));
  const places = rim!.map((corner) => whole.triangles[corner]!);
  expect(new Set(places)).toEqual(new Set(openLoops(whole)[0]));
});

test('two holes that meet in a vertex are no loops, for it is not clear where they go on', () => {
  const loops = openLoops(sheet(8, 8, (x, y) => (x === 3 && y === 3) || (x === 4 && y === 4)));
  expect(loops.map(({ length }) => length)).toEqual([28]);
});

test('a closed surface has no opening', () => {
  const tetrahedron = Uint32Array.from([0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0]);
  expect(openLoops({ triangles: tetrahedron, welded: Int32Array.from([0, 1, 2, 3]) })).toEqual([]);
});

test('lengths along a loop end with the whole of it, and lead back to its vertices', () => {
  const { positions, ...surface } = sheet(4, 5);
  const rim = openLoops(surface)[0]!;
  const lengths = arcLengths(rim, positions);
  expect(lengths.at(-1)).toBe(14);
  for (const i of rim.keys()) expect(indexAt(lengths, lengths[i]! + 0.3)).toBe(i);
  expect(indexAt(lengths, -1)).toBe(rim.length - 1);
  expect(indexAt(lengths, 14 * 3 + 2)).toBe(2);
});
