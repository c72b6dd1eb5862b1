import { expect, test } from 'vitest';
import { PairTool } from '../../../web/tools/transfer/pair-tool';
import { at } from '../table';
import { Chair, point, region } from './chair';

const seat = (...handles: Parameters<typeof region>[]) => new Chair(handles.map((set) => region(...set)));

test('a stroke is the counterpart of the handle in hand, and more strokes add to it', () => {
  const chair = seat([1], [2]);
  chair.selected = 1;
  const tool = new PairTool(chair);
  chair.table.stroke(tool, [
    [3, 3],
    [8, 3],
  ]);
  chair.table.click(tool, 15, 15);
  expect(chair.has(1)).toEqual(expect.arrayContaining([at(3, 3), at(6, 3), at(8, 3), at(15, 15)]));
  expect(chair.has(0)).toEqual([]);
  expect(chair.commits).toEqual([
    ['paint', 1],
    ['paint', 1],
  ]);
  expect(chair.picks).toEqual([]);
});

test('without one in hand the next open handle is taken, or the counterpart under the pointer', () => {
  const chair = seat([1], [2]);
  chair.give(0, at(5, 5));
  const tool = new PairTool(chair);
  chair.table.click(tool, 15, 15);
  expect(chair.picks).toEqual([1]);
  expect(chair.has(1)).toContain(at(15, 15));
  chair.selected = null;
  chair.table.click(tool, 5, 5);
  expect(chair.picks).toEqual([1, 0]);
  expect(chair.commits.at(-1)).toEqual(['paint', 0]);
});

test('when all are paired and none is in hand, the camera has the pointer', () => {
  const chair = seat([1]);
  chair.give(0, at(5, 5));
  expect(chair.table.click(new PairTool(chair), 15, 15)).toBe(false);
  expect(chair.commits).toEqual([]);
});

test('Alt takes away, and what is painted over changes sides', () => {
  const chair = seat([1], [2]);
  chair.give(0, at(5, 5), at(12, 12));
  chair.selected = 1;
  const tool = new PairTool(chair);
  chair.table.click(tool, 5, 5);
  expect(chair.has(0)).toEqual([at(12, 12)]);
  expect(chair.has(1)).toContain(at(5, 5));
  chair.table.click(tool, 5, 5, { alt: true });
  expect(chair.has(1)).toEqual([]);
});

test('a point is placed where the pointer is let go', () => {
  const chair = new Chair([point(1)]);
  chair.selected = 0;
  const tool = new PairTool(chair);
  tool.down(chair.table.sample(3, 3));
  expect([...chair.painted!.vertices]).toEqual([at(3, 3)]);
  tool.move([chair.table.sample(9, 4)]);
  expect([...chair.painted!.vertices]).toEqual([at(9, 4)]);
  expect(chair.commits).toEqual([]);
  // Let go beside the model it stays where it was last.
  tool.up(chair.table.sample(-5, 4));
  expect(chair.has(0)).toEqual([at(9, 4)]);
  expect(chair.painted).toBeNull();
  chair.table.click(tool, 2, 2);
  expect(chair.has(0)).toEqual([at(2, 2)]);
});

test('the brush shows where it paints, not where it places a point', () => {
  const chair = new Chair([region(1), point(2)]);
  const tool = new PairTool(chair);
  chair.selected = 0;
  tool.hover(chair.table.sample(5, 5));
  expect(chair.table.brushShown).not.toBeNull();
  chair.selected = 1;
  tool.hover(chair.table.sample(5, 5));
  expect(chair.table.brushShown).toBeNull();
});

test.each([['region', region(1)] as const, ['point', point(1)] as const])(
  'Escape in the middle leaves no trace: %s',
  (_, handle) => {
    const chair = new Chair([handle]);
    chair.selected = 0;
    const { step } = chair;
    const tool = new PairTool(chair);
    tool.down(chair.table.sample(5, 5));
    tool.move([chair.table.sample(8, 5)]);
    expect(chair.painted).not.toBeNull();
    tool.cancel();
    tool.up(chair.table.sample(9, 5));
    expect(chair.painted).toBeNull();
    expect(chair.step).toBe(step);
  },
);

test('beside the model, with another button, or without a scene the camera has the pointer', () => {
  const chair = seat([1]);
  const tool = new PairTool(chair);
  expect(tool.down(chair.table.sample(-3, 5))).toBe(false);
  expect(tool.down(chair.table.sample(5, 5, { button: 2 }))).toBe(false);
  const absent = new PairTool(Object.assign(seat([1]), { scene: () => null }));
  expect(absent.down(chair.table.sample(5, 5))).toBe(false);
});
