// Sharp edges by hand, on a gutter of 200 × 200 CSS pixels: three strips of four squares, the middle one sunk, seen from above.

import { describe, expect, test } from 'vitest';
import { type MatchStep, newMatchStep } from '../../../web/recipe/steps/match';
import { EdgeGraph } from '../../../web/tools/edge-graph';
import { withSharp } from '../../../web/tools/match/edits';
import type { MatchHost, MatchScene } from '../../../web/tools/match/host';
import { SharpTool } from '../../../web/tools/match/sharp-tool';
import type { Hit, PointerSample, Vec3 } from '../../../web/view/types';

const WIDE = 4;
const LONG = 5;
const CELL = 50;
const DEPTH = [0, -60, -60, 0];
/** Vertex of a column and a row. */
const at = (column: number, row: number) => row * WIDE + column;
const positions = Float64Array.from(
  Array.from({ length: LONG }, (_, row) =>
    Array.from({ length: WIDE }, (_, column) => [column * CELL, row * CELL, DEPTH[column]!]),
  ).flat(2),
);
const faces = Array.from({ length: LONG - 1 }, (_, row) =>
  Array.from({ length: WIDE - 1 }, (_, column) => [
    at(column, row),
    at(column + 1, row),
    at(column + 1, row + 1),
    at(column, row + 1),
  ]),
).flat();
const triangles = Uint32Array.from(faces.flatMap(([a, b, c, d]) => [a!, b!, c!, a!, c!, d!]));
const faceOfTriangle = Uint32Array.from(faces.flatMap((_, face) => [face, face]));
const welded = Int32Array.from({ length: WIDE * LONG }, (_, v) => v);
const EDGES = new EdgeGraph({ positions, triangles, faceOfTriangle, welded });

function hitAt(x: number, y: number): Hit | null {
  if (x < 0 || y < 0 || x > (WIDE - 1) * CELL || y > (LONG - 1) * CELL) return null;
  const vertex = at(Math.round(x / CELL), Math.round(y / CELL));
  return { point: [x, y, 0], normal: [0, 0, 1], triangle: 0, vertex, distance: 5000 };
}

const sample = (x: number, y: number, shift = false): PointerSample => ({
  ...{ x, y, shift, pressure: 0.5, pointerType: 'mouse', button: 0, alt: false, ctrl: false },
  hit: hitAt(x, y),
});

class Seat {
  step: MatchStep = newMatchStep('m', ['a', 'b']);
  selected: number | null = null;
  line: readonly Vec3[] | null = null;
  readonly view = {
    pick: hitAt,
    project: ([x, y]: Vec3) => ({ x, y, behind: false }),
    camera: { position: [0, 0, 1000] as Vec3, target: [0, 0, 0] as Vec3, orthographic: true },
  };

  scene(): Partial<MatchScene> {
    const sharp = this.step.sharp?.[1] ?? [];
    const model = { name: 'gutter', positions, faceOffsets: new Uint32Array(), faceVertices: triangles };
    const surface = { model, opened: { triangles, faceOfTriangle } };
    return { step: this.step, at: 1, surface, sharp, sharpRow: this.selected, edges: () => EDGES };
  }

  showLine(line: readonly Vec3[] | null): void {
    this.line = line;
  }

  commitSharp(row: number, vertices: readonly number[]): void {
    this.step = withSharp(this.step, 1, row, vertices);
    this.selected = vertices.length > 1 ? row : null;
  }

  get rows() {
    return (this.step.sharp?.[1] ?? []).map((row) => (row[0]! < row.at(-1)! ? row : [...row].reverse()));
  }
}

const begin = () => {
  const seat = new Seat();
  return { seat, tool: new SharpTool(seat as unknown as MatchHost) };
};

function press(tool: SharpTool, shift: boolean, ...places: [number, number][]): boolean {
  const [first, ...rest] = places;
  if (!tool.down(sample(...first!, shift))) return false;
  for (const place of rest) tool.move([sample(...place, shift)]);
  tool.up(sample(...places.at(-1)!, shift));
  return true;
}

const column = (c: number, from = 0, to = LONG - 1) =>
  Array.from({ length: to - from + 1 }, (_, i) => at(c, from + i));

describe('a click', () => {
  test('takes a crease as far as it runs, and again leaves it', () => {
    const { seat, tool } = begin();
    press(tool, false, [54, 75]);
    expect(seat.rows).toEqual([column(1)]);
    press(tool, false, [97, 120]);
    expect(seat.rows).toEqual([column(1), column(2)]);
    press(tool, false, [47, 130]);
    expect(seat.rows).toEqual([column(2)]);
    press(tool, false, [101, 20]);
    expect(seat.step.sharp).toBeUndefined();
  });

  test('takes a smooth edge alone, and nothing in the middle of a face', () => {
    const { seat, tool } = begin();
    press(tool, false, [125, 52]);
    expect(seat.rows).toEqual([[at(2, 1), at(3, 1)]]);
    press(tool, false, [125, 125]);
    expect(seat.rows).toHaveLength(1);
  });

  test('beside the model is the camera’s', () => {
    expect(begin().tool.down(sample(-20, 50))).toBe(false);
  });

  test('is foretold by what lies under the pointer', () => {
    const { seat, tool } = begin();
    tool.hover(sample(53, 60));
    expect(seat.line).toHaveLength(LONG);
    tool.leave();
    expect(seat.line).toBeNull();
  });
});

describe('a path', () => {
  test('is dragged along edges', () => {
    const { seat, tool } = begin();
    press(tool, false, [52, 3], [55, 60], [52, 149]);
    expect(seat.rows).toEqual([column(1, 0, 3)]);
    expect(seat.line).toBeNull();
  });

  test('is gone on with by Shift, from its nearer end', () => {
    const { seat, tool } = begin();
    press(tool, false, [52, 52], [52, 98]);
    press(tool, true, [52, 199]);
    expect(seat.rows).toEqual([column(1, 1, 4)]);
    press(tool, true, [52, 2]);
    expect(seat.rows).toEqual([column(1)]);
  });

  test('that is given up leaves nothing', () => {
    const { seat, tool } = begin();
    tool.down(sample(52, 3));
    tool.move([sample(52, 149)]);
    expect(seat.line).not.toBeNull();
    tool.cancel();
    expect([seat.line, seat.step.sharp]).toEqual([null, undefined]);
  });
});
