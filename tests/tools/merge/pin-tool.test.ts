import { beforeEach, expect, test } from 'vitest';
import { newMergeStep } from '../../../web/recipe/steps/merge';
import type { MergeEditLabel, MergeHost, MergeScene } from '../../../web/tools/merge/host';
import { type Loop, openLoops } from '../../../web/tools/merge/loops';
import { PinTool } from '../../../web/tools/merge/pin-tool';
import { type MergeBoundary, pinsOf } from '../../../web/tools/merge/pins';
import { MeshGraph } from '../../../web/tools/mesh-graph';
import type { PointerSample } from '../../../web/view/types';
import { sheet } from './shapes';

/** A sheet with a square hole, seen from above: ten CSS pixels a cell. */
const model = sheet(9, 9, (x, y) => x > 2 && x < 5 && y > 2 && y < 5);
const [rim, hole] = openLoops(model) as [Loop, Loop];
const PIXELS = 10;

let boundaries: MergeBoundary[];
let previewed: readonly MergeBoundary[] | null;
let log: (MergeEditLabel | 'select' | 'cancel' | Loop)[];
let hovered: Loop | null;

const host: MergeHost = {
  side: 'source',
  view: {
    pick: () => null,
    verticesWithin: () => new Uint32Array(),
    pixelSize: () => 1 / PIXELS,
    setBrush: () => {},
    project: ([x, y]) => ({ x: PIXELS * x, y: PIXELS * y, behind: false }),
    camera: { position: [4, 4, 50], target: [4, 4, 0], orthographic: false },
  },
  brush: () => ({ radius: 1, erase: false }),
  scene: (): MergeScene => ({
    step: { ...newMergeStep('merge 1', 'a', 'b'), boundaries },
    positions: { source: model.positions, target: model.positions },
    loops: [rim, hole],
    pins: pinsOf(boundaries),
    boundaries,
    selected: null,
    mark: () => new Uint32Array(),
    graph: new MeshGraph(model),
    mirrored: (set) => set,
  }),
  commitMark: () => {},
  showPaint: () => {},
  preview: (next) => {
    previewed = next;
  },
  commit: (label, next) => {
    log.push(label);
    boundaries = [...next];
  },
  cancel: () => void log.push('cancel'),
  select: () => void log.push('select'),
  hoverLoop: (loop) => {
    hovered = loop;
  },
  pickLoop: (loop) => void log.push(loop),
};

let tool: PinTool;
beforeEach(() => {
  boundaries = [];
  previewed = null;
  log = [];
  hovered = null;
  tool = new PinTool(host);
});

const keys = { shift: false, alt: false, ctrl: false };
const sample = (vertex: number, how: Partial<PointerSample> = {}): PointerSample => ({
  x: PIXELS * model.positions[3 * vertex]!,
  y: PIXELS * model.positions[3 * vertex + 1]!,
  pressure: 0.5,
  pointerType: 'mouse',
  button: 0,
  hit: null,
  ...keys,
  ...how,
});
const joined = (...pins: [number, number][]): MergeBoundary[] => [
  { source: [...rim], target: [...rim].reverse(), keys: pins, sourceKeep: [], targetKeep: [] },
];

test('an opening under the pointer is shown, and picked by a click', () => {
  tool.hover(sample(hole[2]!));
  expect(hovered).toBe(hole);
  tool.leave();
  expect(hovered).toBeNull();
  expect(tool.down(sample(hole[2]!))).toBe(true);
  expect(log).toEqual([hole]);
});

test('away from every loop the camera has the pointer', () => {
  expect(tool.down(sample(9 * 4 + 1, { x: 9, y: 42 }))).toBe(true); // the rim is near
  expect(tool.down(sample(0, { x: 16, y: 16 }))).toBe(false);
  expect(tool.down(sample(rim[0]!, { button: 2 }))).toBe(false);
});

test('a click on a joined loop sets a pin there', () => {
  boundaries = joined([rim[0]!, rim[0]!]);
  tool.down(sample(rim[8]!));
  expect(log).toEqual(['add-pin']);
  expect(boundaries[0]!.keys.map(([s]) => s)).toEqual([rim[0], rim[8]]);
});

test('a pin is dragged along its loop, previewed on the way and committed once', () => {
  boundaries = joined([rim[0]!, rim[0]!], [rim[16]!, rim[16]!]);
  tool.down(sample(rim[16]!));
  tool.move([sample(rim[17]!)]);
  tool.move([sample(rim[19]!)]);
  expect(previewed![0]!.keys[1]).toEqual([rim[19], rim[16]]);
  tool.up(sample(rim[20]!));
  expect(log).toEqual(['select', 'move-pin']);
  expect(boundaries[0]!.keys).toEqual([
    [rim[0], rim[0]],
    [rim[20], rim[16]],
  ]);
});

test('a press on a pin without a move only selects it; Escape takes a drag back', () => {
  boundaries = joined([rim[0]!, rim[0]!]);
  tool.down(sample(rim[0]!));
  tool.up(sample(rim[0]!));
  expect(log).toEqual(['select']);
  tool.down(sample(rim[0]!));
  tool.move([sample(rim[5]!)]);
  tool.cancel();
  tool.up(sample(rim[5]!));
  expect(log).toEqual(['select', 'select', 'cancel']);
});

test('Alt and a click take a pin away', () => {
  boundaries = joined([rim[0]!, rim[0]!], [rim[16]!, rim[16]!]);
  tool.down(sample(rim[16]!, { alt: true }));
  expect(log).toEqual(['remove-pin']);
  expect(boundaries[0]!.keys).toEqual([[rim[0], rim[0]]]);
});
