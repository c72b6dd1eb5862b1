// The transfer workspace on screen: the model with the pose in a pane, the one that gets it in the main viewport, the
// handles of both.

import { effect } from '@preact/signals';
import { holds } from '../../core/vertex-set';
import type { DeformHandle } from '../../recipe/recipe';
import type { ModelResult } from '../../run/types';
import { pointAt } from '../../tools/geometry';
import { PickTool } from '../../tools/pick-tool';
import { counterpartAt } from '../../tools/transfer/edits';
import { PairTool } from '../../tools/transfer/pair-tool';
import { MARKERS } from '../../view/overlays/markers';
import type { MarkersPort, PointMarker } from '../../view/overlays/types';
import type { RegionPaint, ViewportPort } from '../../view/types';
import { listed, PaintedRegions } from '../painted-regions';
import { viewModel } from '../shown-model';
import { PointerSwitch } from '../tools';
import type { Mounted } from '../wing';
import type { WingParts } from '../wing-parts';
import type { TransferActions } from './actions';
import { AppTransferHost } from './host';
import type { TransferState } from './state';

type Parts = Pick<WingParts, 'state' | 'document' | 'evaluator' | 'settings' | 'panes'>;

export function mountTransfer(
  viewport: ViewportPort,
  parts: Parts,
  own: TransferState,
  actions: TransferActions,
): Mounted {
  const host = new AppTransferHost(viewport, parts, actions);
  const markers = viewport.mount(MARKERS);
  const painted = new PaintedRegions(viewport);
  const frame = framing(viewport, () => own.positions.peek() !== null);
  const stop = effect(() => showTarget(painted, markers.port, host, parts, own, actions));
  const [pane] = parts.panes.take(1) ?? [];
  const source = pane && mountSource(pane.viewport, parts, own, actions);
  const pick = new PickTool({
    at: ({ x, y, hit }) => {
      const scene = host.scene();
      if (!scene) return null;
      const marker = markers.port.pickMarker(x, y);
      if (marker !== null) return Number(marker);
      const index = hit ? counterpartAt(scene.step, hit.vertex) : -1;
      return index < 0 ? null : index;
    },
    pick: (handle) => parts.document.select(handle),
  });
  return {
    tools: { 'pick-pair': pick, 'paint-pair': new PairTool(host) },
    cancel: () => source?.cancel() ?? false,
    unmount: () => {
      stop();
      frame.stop();
      source?.stop();
      painted.clear();
      markers.unmount();
    },
  };
}

/**
 * Frames what a viewport shows, once that is there: a pane has its size only once it is on the page, and a pose may reach
 * further than the model at rest.
 */
function framing(viewport: ViewportPort, isThere: () => boolean): { again(): void; stop(): void } {
  let isFramed = false;
  const stop = viewport.onDraw(() => {
    if (isFramed || viewport.size.width <= 1 || !isThere()) return;
    isFramed = true;
    viewport.fit();
  });
  return {
    again: () => {
      isFramed = false;
    },
    stop,
  };
}

/** The counterparts on the model that gets the pose, where that is now. */
function showTarget(
  painted: PaintedRegions,
  markers: MarkersPort,
  host: AppTransferHost,
  { state, evaluator }: Parts,
  own: TransferState,
  actions: TransferActions,
): void {
  const { item: selected } = state.selection.value;
  const stroke = host.paint.value;
  const evaluation = evaluator.result.value;
  const pose = actions.pose();
  const step = own.step.value;
  if (!pose || !step || evaluation?.step.id !== step.id || state.choosing.value) {
    painted.clear();
    markers.setMarkers([]);
    return;
  }
  const { positions, shown } = evaluation;
  const count = positions.length / 3;
  const parts = pose.handles.map(({ kind }, index): Part => {
    const isPainted = stroke !== null && index === selected;
    const vertices = isPainted ? stroke.vertices : listed(step.handles[index] ?? [], count);
    return { index, kind, vertices, open: false };
  });
  painted.show(shown, regionsOf(parts, selected));
  markers.setMarkers(markersOf(parts, positions, selected));
}

/** One handle or its counterpart, ready to draw. */
interface Part {
  readonly index: number;
  readonly kind: DeformHandle['kind'];
  readonly vertices: Uint32Array;
  /** It has no counterpart. */
  readonly open: boolean;
}

const regionsOf = (parts: readonly Part[], selected: number | null): RegionPaint[] =>
  parts
    .filter(({ kind }) => kind === 'region')
    .map(({ index, vertices, open }) => ({
      id: String(index),
      tint: open ? 'yellow' : 'violet',
      vertices,
      visible: true,
      selected: index === selected,
    }));

const markersOf = (parts: readonly Part[], positions: Float64Array, selected: number | null): PointMarker[] =>
  parts
    .filter(({ kind, vertices }) => kind === 'point' && vertices.length > 0)
    .map(({ index, vertices }) => ({
      id: String(index),
      position: pointAt(positions, vertices[0]!),
      visible: true,
      selected: index === selected,
    }));

interface Source {
  /** @returns whether there was a gesture to end */
  cancel(): boolean;
  stop(): void;
}

/** The model with the pose, and its handles to be picked; elsewhere the camera has the pointer. */
function mountSource(
  viewport: ViewportPort,
  { state, settings }: Parts,
  own: TransferState,
  actions: TransferActions,
): Source {
  const markers = viewport.mount(MARKERS);
  const pick = new PickTool({
    at: ({ x, y, hit }) => {
      const handles = own.source.peek()?.handles ?? [];
      const marker = markers.port.pickMarker(x, y);
      if (marker !== null) return Number(marker);
      const index = hit
        ? handles.findIndex(({ kind, vertices }) => kind === 'region' && holds(vertices, hit.vertex))
        : -1;
      return index < 0 ? null : index;
    },
    pick: (handle) => {
      if (own.step.peek() && !state.choosing.peek()) actions.pick(handle);
    },
  });
  const pointer = new PointerSwitch(viewport, () => pick, settings);
  viewport.setPointerHandler(pointer);
  const painted = new PaintedRegions(viewport);
  let shown: ModelResult['opened'] | null = null;
  const frame = framing(viewport, () => shown !== null);
  const stops = [
    effect(() => {
      const source = own.source.value;
      const rest = own.atRest.value && !state.choosing.value;
      if (source?.rest.opened !== shown) {
        viewport.setModel(source && viewModel(source.rest.model, source.rest.opened));
        frame.again();
      }
      shown = source?.rest.opened ?? null;
      if (!source) return;
      viewport.setPositions(rest ? source.rest.model.positions : source.posed);
      viewport.settlePositions();
    }),
    effect(() => {
      const source = own.source.value;
      if (!source) return;
      const { item: selected } = state.selection.value;
      const open = new Set(own.step.value && !state.choosing.value ? actions.open() : []);
      const positions = own.atRest.value ? source.rest.model.positions : source.posed;
      const count = positions.length / 3;
      const parts = source.handles.map(({ kind, vertices }, index): Part => {
        return { index, kind, vertices: listed(vertices, count), open: open.has(index) };
      });
      const picked = state.choosing.value ? null : selected;
      painted.show(source.rest, regionsOf(parts, picked));
      markers.port.setMarkers(markersOf(parts, positions, picked));
    }),
    effect(() => viewport.setDisplay(state.display.value)),
  ];
  return {
    cancel: () => pointer.cancel(),
    stop: () => {
      for (const stop of stops) stop();
      frame.stop();
      markers.unmount();
      painted.clear();
      viewport.setModel(null);
      viewport.setPointerHandler(null);
    },
  };
}
