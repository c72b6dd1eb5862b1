import { expect, test } from 'vitest';
import type { BlendHost, Length } from '../../../web/tools/blend/host';
import { LengthTool } from '../../../web/tools/blend/length-tool';
import type { PointerSample } from '../../../web/view/types';

class Seat {
  from: number | null = null;
  shown: Length | null = null;
  readonly measured: Length[] = [];
  scene = () => ({});
  lengthFrom = () => this.from;
  beginLength(vertex: number): void {
    this.from = vertex;
  }
  showLength(length: Length | null): void {
    this.shown = length;
  }
  measureLength(from: number, to: number, straight: boolean): void {
    this.measured.push({ from, to, straight });
    this.from = null;
  }
}

/** Over a vertex; `null`: beside the model. */
const sample = (vertex: number | null, shift = false): PointerSample => ({
  ...{ x: 0, y: 0, pressure: 0.5, pointerType: 'mouse', button: 0, shift, alt: false, ctrl: false },
  hit: vertex === null ? null : { point: [0, 0, 0], normal: [0, 0, 1], triangle: 0, vertex, distance: 1 },
});

function click(tool: LengthTool, vertex: number | null, shift = false): boolean {
  const taken = tool.down(sample(vertex, shift));
  if (taken) tool.up(sample(vertex, shift));
  return taken;
}

test('two clicks measure, along the surface or with Shift straight through', () => {
  const seat = new Seat();
  const tool = new LengthTool(seat as unknown as BlendHost);
  tool.hover(sample(3));
  expect(seat.shown).toBeNull();
  click(tool, 3);
  tool.hover(sample(5));
  expect(seat.shown).toEqual({ from: 3, to: 5, straight: false });
  click(tool, 3);
  expect(seat.measured).toEqual([]);
  click(tool, 5);
  click(tool, 8);
  click(tool, 9, true);
  expect(seat.measured).toEqual([
    { from: 3, to: 5, straight: false },
    { from: 8, to: 9, straight: true },
  ]);
});

test('beside the model the camera has the pointer', () => {
  const seat = new Seat();
  const tool = new LengthTool(seat as unknown as BlendHost);
  expect(click(tool, null)).toBe(false);
  click(tool, 3);
  tool.leave();
  expect(seat.shown).toBeNull();
});
