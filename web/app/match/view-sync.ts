// The match workspace on screen: the first model in the main viewport, each other one in a pane, with their skins, lines
// and masks, and the tools on all of them. Numbers lie over the panes, on the page.

import { effect, untracked } from '@preact/signals';
import { diagonalOf } from '../../core/diagonal';
import { add, cross, pointAt, scaled, subtract, unit } from '../../tools/geometry';
import { CurveTool } from '../../tools/match/curve-tool';
import { MarkerTool } from '../../tools/match/marker-tool';
import { maskTool } from '../../tools/match/mask-tool';
import { pointOf } from '../../tools/match/places';
import { SharpTool } from '../../tools/match/sharp-tool';
import type { Tool } from '../../tools/tool';
import { SKIN } from '../../view/match/skin-layer';
import type { Skin } from '../../view/match/types';
import { CONTROL_LINES } from '../../view/overlays/control-lines';
import type { ControlLine } from '../../view/overlays/types';
import type { Vec3, ViewportPort } from '../../view/types';
import { listed, PaintedRegions } from '../painted-regions';
import { paneModel } from '../panes';
import { PointerSwitch } from '../tools';
import type { Mounted } from '../wing';
import type { WingParts } from '../wing-parts';
import type { MatchActions } from './actions';
import { AppMatchHost } from './host';
import { heatTop } from './result';
import type { MatchState } from './state';

type Parts = Pick<WingParts, 'state' | 'document' | 'settings' | 'panes' | 'runner' | 'messages'>;

interface Synced extends Pick<Framing, 'again'> {
  readonly tools: Readonly<Record<string, Tool>>;
  readonly cancel: () => boolean;
  readonly stop: () => void;
}

export function mountMatch(
  viewport: ViewportPort,
  parts: Parts,
  own: MatchState,
  actions: MatchActions,
): Mounted {
  const main = syncModel(0, viewport, parts, own, actions);
  const frame = framing(viewport, own, 0);
  const others: Synced[] = [];
  const stops = [
    // As many panes as there are models beside the first; they stay while only what is in them changes.
    effect(() => {
      const wanted = Math.max(0, own.models.value.length - 1);
      untracked(() => {
        for (const gone of others.splice(wanted)) gone.stop();
        const panes = parts.panes.take(wanted) ?? [];
        for (const pane of panes.slice(others.length))
          others.push(syncPane(others.length + 1, pane.viewport, parts, own, actions));
      });
    }),
    effect(() => {
      // Of another step, or of other models, nothing is looked at.
      if (own.poor.value !== null && (!own.result.value || own.marker.value !== null)) own.poor.value = null;
    }),
    () => frame.stop(),
    // Among more or fewer each has another size.
    effect(() => {
      if (own.models.value.length > 0) for (const each of [frame, ...others]) each.again();
    }),
  ];
  return {
    tools: main.tools,
    cancel: () => others.map(({ cancel }) => cancel()).some((active) => active),
    unmount: () => {
      for (const stop of stops) stop();
      for (const each of [main, ...others]) each.stop();
      viewport.setDisplay(parts.state.display.peek());
    },
  };
}

/** A model in a pane of its own. */
function syncPane(
  at: number,
  viewport: ViewportPort,
  parts: Parts,
  own: MatchState,
  actions: MatchActions,
): Synced {
  const show = paneModel(viewport);
  const shown = effect(() => show(own.models.value[at] ?? null));
  const synced = syncModel(at, viewport, parts, own, actions);
  const pointer = new PointerSwitch(viewport, () => synced.tools[parts.state.tool.peek()], parts.settings);
  viewport.setPointerHandler(pointer);
  const frame = framing(viewport, own, at);
  return {
    tools: synced.tools,
    again: () => frame.again(),
    cancel: () => pointer.cancel(),
    stop: () => {
      frame.stop();
      synced.stop();
      shown();
      show(null);
      viewport.setPointerHandler(null);
    },
  };
}

interface Framing {
  /** Once more, as soon as the viewport has its new size. */
  again(): void;
  stop(): void;
}

/** Milliseconds that a page may take to be laid out for more or fewer models. */
const LAYOUT = 1000;

/** Frames what a viewport shows once it has its size beside the others: again with each size while the page is laid out anew. */
function framing(viewport: ViewportPort, own: MatchState, at: number): Framing {
  let framed = '';
  let until = Number.POSITIVE_INFINITY;
  const stop = viewport.onDraw(() => {
    const { width, height } = viewport.size;
    const size = `${width} ${height}`;
    const now = performance.now();
    if (now > until || size === framed || width <= 1 || !own.models.peek()[at]) return;
    framed = size;
    // From the first frame on: what came before was waiting.
    until = Math.min(until, now + LAYOUT);
    viewport.fit();
  });
  return {
    again: () => {
      until = Number.POSITIVE_INFINITY;
    },
    stop,
  };
}

/** What is seen on a model in a viewport that shows it. */
function syncModel(
  at: number,
  viewport: ViewportPort,
  parts: Parts,
  own: MatchState,
  actions: MatchActions,
): Omit<Synced, 'again'> {
  const { state } = parts;
  const host = new AppMatchHost(at, viewport, { ...parts, own, actions });
  const skin = viewport.mount(SKIN);
  const lines = viewport.mount(CONTROL_LINES);
  const painted = new PaintedRegions(viewport);
  const stops = [
    effect(() => skin.port.setSkin(skinLook(own, at))),
    effect(() => showMask(painted, own, at)),
    effect(() => lines.port.setLines(linesOf(own, at, Boolean(state.choosing.value)))),
    effect(() => {
      const display = state.display.value;
      const alone = own.skinOf(at) !== null && own.lookOf(at) === 'skin';
      viewport.setDisplay(alone ? { ...display, wireframe: false } : display);
    }),
    effect(() => {
      const vertex = own.poor.value;
      if (vertex === null) return;
      untracked(() => lookAt(viewport, own, at, vertex));
    }),
  ];
  return {
    tools: {
      'match-marker': new MarkerTool(host, true),
      'match-turn': new MarkerTool(host, false),
      'match-curve': new CurveTool(host),
      'match-sharp': new SharpTool(host),
      'match-mask': maskTool(host),
    },
    cancel: () => false,
    stop: () => {
      for (const stop of stops) stop();
      skin.unmount();
      lines.unmount();
      painted.clear();
    },
  };
}

function skinLook(own: MatchState, at: number) {
  const skin = own.skinOf(at);
  const look = own.lookOf(at);
  if (!skin || look === 'model') return null;
  const result = own.growing.value ? null : own.result.value;
  const heat = own.heat.value && result ? heatOf(result.residuals[at]!, heatTop(result)) : undefined;
  return { skin, alone: look === 'skin', edges: own.edges.value, heat };
}

const heats = new WeakMap<Float32Array, Float32Array>();

function heatOf(residuals: Float32Array, top: number): Float32Array {
  let heat = heats.get(residuals);
  if (!heat) {
    heat = residuals.map((distance) => distance / top);
    heats.set(residuals, heat);
  }
  return heat;
}

function showMask(painted: PaintedRegions, own: MatchState, at: number): void {
  const shown = own.models.value[at];
  const step = own.step.value;
  if (!shown || !step) {
    painted.clear();
    return;
  }
  const stroke = own.stroke.value;
  const vertices =
    (stroke?.model === at ? stroke.mask : undefined) ??
    listed(step.mask?.[at] ?? [], shown.model.positions.length / 3);
  painted.show(shown, [{ id: 'mask', tint: 'red', vertices, visible: true, selected: false }]);
}

function linesOf(own: MatchState, at: number, choosing: boolean): ControlLine[] {
  const shown = own.models.value[at];
  const step = own.step.value;
  if (!shown || !step || choosing) return [];
  const selected = own.curve.value;
  const line = (
    id: string,
    points: readonly Vec3[],
    isSelected: boolean,
    tint: ControlLine['tint'] = isSelected ? 'cyan' : 'yellow',
  ): ControlLine => ({ id, points, tint, selected: isSelected, plain: true });
  const drawn = (step.curves ?? []).flatMap((rows, curve): ControlLine[] => {
    const points = (rows[at] ?? []).map((place) => pointOf(shown, place)).filter((point) => point !== null);
    return points.length > 1 ? [line(String(curve), points, curve === selected)] : [];
  });
  const { positions } = shown.model;
  const row = (vertices: ArrayLike<number>) => Array.from(vertices, (v) => pointAt(positions, v));
  // What an angle keeps lies below what was picked.
  const kept = (own.kept.value[at] ?? []).map((each, i) => line(`kept ${i}`, row(each), false, 'blue'));
  const chosen = own.sharp.value;
  const picked = (step.sharp?.[at] ?? [])
    .filter((each) => each.every((v) => 3 * v < positions.length))
    .map((each, i) => line(`sharp ${i}`, row(each), chosen?.model === at && chosen.row === i, 'coral'));
  const lines = [...kept, ...picked, ...drawn];
  const stroke = own.stroke.value;
  const under = stroke?.model === at ? (stroke.line ?? []) : [];
  return under.length > 1 ? [...lines, line('stroke', under, true)] : lines;
}

/** Of the model's size: how far off a poor place is looked at. */
const AWAY = 0.42;

/** Turns the camera to a vertex of the skin, so that it is seen from straight before it. */
function lookAt(viewport: ViewportPort, own: MatchState, at: number, vertex: number): void {
  const skin = own.skinOf(at);
  const shown = own.models.peek()[at];
  if (!skin || !shown) return;
  const target = pointAt(skin.positions, vertex);
  const normal = normalAt(skin, vertex);
  const position = add(target, scaled(normal, AWAY * diagonalOf(shown.model.positions)));
  viewport.camera = { ...viewport.camera, position, target };
}

/** By the triangles around it, each as much as it is large. */
function normalAt({ triangles, positions }: Skin, vertex: number): Vec3 {
  let sum: Vec3 = [0, 0, 0];
  for (let t = 0; t < triangles.length; t += 3) {
    const [i, j, k] = [triangles[t]!, triangles[t + 1]!, triangles[t + 2]!];
    if (i !== vertex && j !== vertex && k !== vertex) continue;
    const [a, b, c] = [pointAt(positions, i), pointAt(positions, j), pointAt(positions, k)];
    sum = add(sum, cross(subtract(b, a), subtract(c, a)));
  }
  return unit(sum, [0, 0, 1]);
}
