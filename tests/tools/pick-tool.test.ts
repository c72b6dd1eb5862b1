import { beforeEach, expect, test } from 'vitest';
import { PickTool } from '../../web/tools/pick-tool';
import { Table } from './table';

const table = new Table();
let picked: number[];
let tool: PickTool;
beforeEach(() => {
  picked = [];
  tool = new PickTool({
    at: ({ x, y }) => (x > 10 && y > 10 ? 4 : null),
    pick: (handle) => void picked.push(handle),
  });
});

test('a click on a handle picks it', () => {
  expect(table.click(tool, 12, 12)).toBe(true);
  expect(picked).toEqual([4]);
});

test('elsewhere, and with another button, the camera has the pointer', () => {
  expect(table.click(tool, 5, 12)).toBe(false);
  expect(table.click(tool, 12, 12, { button: 2 })).toBe(false);
  expect(picked).toEqual([]);
});

test('what is dragged or given up picks nothing', () => {
  table.stroke(tool, [
    [12, 12],
    [19, 12],
  ]);
  tool.down(table.sample(12, 12));
  tool.cancel();
  tool.up(table.sample(12, 12));
  expect(picked).toEqual([]);
});
