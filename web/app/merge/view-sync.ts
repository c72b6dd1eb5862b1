// The merge workspace on screen: the two models in panes of their own, with their marks and loops, and the tools.

import { effect } from '@preact/signals';
import { paintMark } from '../../tools/merge/mark-tool';
import { PinTool } from '../../tools/merge/pin-tool';
import type { MergeSide } from '../../tools/merge/pins';
import type { Tool } from '../../tools/tool';
import { LOOPS } from '../../view/overlays/loops';
import type { LoopLine, LoopsPort } from '../../view/overlays/types';
import type { RegionPaint, ViewportPort } from '../../view/types';
import { paneModel } from '../panes';
import { PointerSwitch } from '../tools';
import type { Mounted } from '../wing';
import type { WingParts } from '../wing-parts';
import type { MergeActions } from './actions';
import { AppMergeHost } from './host';
import type { MergeState } from './state';
import { MARKS, markOf, sideOfMark } from './steps';

type Parts = Pick<WingParts, 'state' | 'document' | 'settings' | 'panes'>;

/** In the order of the panes. */
export const SIDES = ['source', 'target'] as const satisfies readonly MergeSide[];

const TINTS = { source: 'red', feature: 'yellow', target: 'azure' } as const;

interface SyncedPane {
  readonly cancel: () => boolean;
  readonly stop: () => void;
}

/** In the main viewport, which shows what comes of it, only the camera moves. */
export function mountMerge(parts: Parts, own: MergeState, actions: MergeActions): Mounted {
  const panes = parts.panes.take(SIDES.length) ?? [];
  const synced = panes.map(({ viewport }, i) => syncPane(SIDES[i]!, viewport, parts, own, actions));
  return {
    tools: {},
    cancel: () => synced.map(({ cancel }) => cancel()).some((active) => active),
    unmount: () => {
      for (const { stop } of synced) stop();
    },
  };
}

function syncPane(
  side: MergeSide,
  viewport: ViewportPort,
  { state, document, settings }: Parts,
  own: MergeState,
  actions: MergeActions,
): SyncedPane {
  const host = new AppMergeHost(side, viewport, { state, document, own, actions });
  const region = paintMark(host, side);
  const tools: Readonly<Record<string, Tool>> = {
    'merge-pins': new PinTool(host),
    'mark-region': region,
    ...(side === 'source' && { 'mark-feature': paintMark(host, 'feature') }),
  };
  const pointer = new PointerSwitch(viewport, () => tools[state.tool.peek()], settings);
  viewport.setPointerHandler(pointer);
  const show = paneModel(viewport);
  const loops = viewport.mount(LOOPS);
  const stops = [
    effect(() => show(own.sides.value[side])),
    effect(() => showMarks(viewport, own, side)),
    effect(() => showLoops(loops.port, own, actions, side)),
    effect(() => viewport.setDisplay(state.display.value)),
    effect(() => {
      if (state.tool.value === 'merge-pins') viewport.setBrush(null);
      else own.hovered.value = null;
    }),
  ];
  return {
    cancel: () => pointer.cancel(),
    stop: () => {
      for (const stop of stops) stop();
      loops.unmount();
      show(null);
      viewport.setPointerHandler(null);
    },
  };
}

function showMarks(viewport: ViewportPort, own: MergeState, side: MergeSide): void {
  const shown = own.sides.value[side];
  const step = own.step.value;
  const paint = own.paint.value;
  if (!shown) return;
  const count = shown.model.positions.length / 3;
  const regions = MARKS.filter((mark) => sideOfMark(mark) === side).map((mark): RegionPaint => {
    const vertices =
      paint?.mark === mark ? paint.vertices : step ? markOf(step, mark, count) : new Uint32Array();
    return { id: mark, tint: TINTS[mark], vertices, visible: true, selected: false };
  });
  viewport.setRegions(regions);
}

function showLoops(loops: LoopsPort, own: MergeState, actions: MergeActions, side: MergeSide): void {
  const shown = own.sides.value[side];
  if (!shown) return;
  const { positions } = shown.model;
  const line = (loop: readonly number[], isOurs: boolean, strong: boolean): LoopLine => ({
    points: Float64Array.from(loop.flatMap((v) => [...positions.subarray(3 * v, 3 * v + 3)])),
    ...(isOurs && { tint: TINTS[side] }),
    strong,
  });
  const joined = (own.step.value?.boundaries ?? []).map((boundary) => boundary[side]);
  const taken = new Set(joined.flat());
  const open = (actions.aids.of(side)?.loops ?? []).filter((loop) => !loop.some((v) => taken.has(v)));
  const marked = [own.hovered.value, own.picked.value].filter((each) => each?.side === side);
  loops.setLoops([
    ...joined.map((loop) => line(loop, true, true)),
    ...open.map((loop) => {
      const strong = marked.some((each) => each?.loop === loop);
      return line(loop, strong, strong);
    }),
  ]);
}
