// The panes of the two models: their pointers go to the tool that is chosen, their pictures follow the state.

import { effect } from '@preact/signals';
import type { ModelResult } from '../../run/types';
import { paintMark } from '../../tools/merge/mark-tool';
import { PinTool } from '../../tools/merge/pin-tool';
import type { MergeSide } from '../../tools/merge/pins';
import type { Tool } from '../../tools/tool';
import { LOOPS } from '../../view/overlays/loops';
import type { LoopLine, LoopsPort } from '../../view/overlays/types';
import type { Tint } from '../../view/palette';
import type { RegionPaint, ViewportPort } from '../../view/types';
import type { SettingsService } from '../api';
import type { Document } from '../document';
import type { State } from '../state';
import { PointerSwitch } from '../tools';
import type { MergeActions } from './actions';
import { AppMergeHost } from './host';
import { MARKS, markOf, sideOfMark } from './steps';

export type Panes = Readonly<Record<MergeSide, ViewportPort>>;

interface Parts {
  readonly state: State;
  readonly document: Document;
  readonly actions: MergeActions;
  readonly settings: SettingsService;
}

interface Synced {
  /** Ends a gesture under way. @returns whether there was one */
  readonly cancel: () => boolean;
  readonly stop: () => void;
}

const TINTS = { source: 'red', feature: 'yellow', target: 'azure' } as const;
const SIDES = ['source', 'target'] as const;

export function syncPanes(panes: Panes, parts: Parts): Synced {
  const synced = SIDES.map((side) => syncPane(side, panes[side], parts));
  return {
    cancel: () => synced.map(({ cancel }) => cancel()).some((active) => active),
    stop: () => {
      for (const { stop } of synced) stop();
    },
  };
}

function syncPane(side: MergeSide, viewport: ViewportPort, parts: Parts): Synced {
  const { state } = parts;
  const host = new AppMergeHost(side, viewport, parts);
  const pins = new PinTool(host);
  const region = paintMark(host, side);
  const tools: Readonly<Record<string, Tool>> = {
    'merge-pins': pins,
    'mark-region': region,
    ...(side === 'source' && { 'mark-feature': paintMark(host, 'feature') }),
  };
  const pointer = new PointerSwitch(viewport, () => tools[state.tool.peek()], parts.settings);
  viewport.setPointerHandler(pointer);
  const loops = viewport.mount(LOOPS);
  let shown: ModelResult | null = null;
  const stops = [
    effect(() => {
      const next = state.merge.sides.value[side];
      // Only another model takes the camera back to where it starts.
      if (next?.opened !== shown?.opened || next?.model.colors !== shown?.model.colors)
        showModel(viewport, next);
      shown = next;
    }),
    effect(() => showMarks(viewport, state, side)),
    effect(() => showLoops(loops.port, parts, side)),
    effect(() => viewport.setDisplay(state.display.value)),
    effect(() => {
      if (state.tool.value === 'merge-pins') viewport.setBrush(null);
      else state.merge.hovered.value = null;
    }),
  ];
  return {
    cancel: () => pointer.cancel(),
    stop: () => {
      for (const stop of stops) stop();
      viewport.setPointerHandler(null);
      loops.unmount();
    },
  };
}

function showModel(viewport: ViewportPort, shown: ModelResult | null): void {
  if (!shown) {
    viewport.setModel(null);
    return;
  }
  const { positions, faceOffsets, faceVertices, colors, upAxis } = shown.model;
  const { triangles, welded } = shown.opened;
  viewport.setModel({
    positions,
    triangles,
    faceOffsets,
    faceVertices,
    welded,
    ...(colors && { colors }),
    ...(upAxis && { upAxis }),
  });
}

function showMarks(viewport: ViewportPort, { merge, mergeStep }: State, side: MergeSide): void {
  const shown = merge.sides.value[side];
  const step = mergeStep.value;
  const paint = merge.paint.value;
  if (!shown) return;
  const count = shown.model.positions.length / 3;
  const regions = MARKS.filter((mark) => sideOfMark(mark) === side).map((mark): RegionPaint => {
    const vertices =
      paint?.mark === mark ? paint.vertices : step ? markOf(step, mark, count) : new Uint32Array();
    return { id: mark, tint: TINTS[mark], vertices, visible: true, selected: false };
  });
  viewport.setRegions(regions);
}

function showLoops(layer: LoopsPort, { state, actions }: Parts, side: MergeSide): void {
  const { merge, mergeStep } = state;
  const shown = merge.sides.value[side];
  if (!shown) return;
  const { positions } = shown.model;
  const line = (loop: readonly number[], strong: boolean, tint?: Tint): LoopLine => ({
    points: Float64Array.from(loop.flatMap((v) => [...positions.subarray(3 * v, 3 * v + 3)])),
    ...(tint && { tint }),
    strong,
  });
  const joined = (mergeStep.value?.boundaries ?? []).map((boundary) => boundary[side]);
  const taken = new Set(joined.flat());
  const open = (actions.aids.of(side)?.loops ?? []).filter((loop) => !loop.some((v) => taken.has(v)));
  const marked = [merge.hovered.value, merge.picked.value].filter((each) => each?.side === side);
  layer.setLoops([
    ...joined.map((loop) => line(loop, true, TINTS[side])),
    ...open.map((loop) => {
      const strong = marked.some((each) => each?.loop === loop);
      return strong ? line(loop, true, TINTS[side]) : line(loop, false);
    }),
  ]);
}
