// Keeps the viewport in step with the state: one effect per thing drawn. Nothing flows back from here.

import { effect } from '@preact/signals';
import { toIndices } from '../core/vertex-set';
import type { DeformHandle } from '../recipe/recipe';
import { GizmoDrag, gizmoFrame } from '../tools/deform/gizmo-drag';
import { markerId } from '../tools/deform/host';
import type { RegionPaint, ViewportPort } from '../view/types';
import type { AppDeformHost } from './deform-host';
import type { Evaluation, Evaluator } from './evaluation';
import { LENGTHS, shownLengths } from './hair/lengths';
import { viewModel } from './hair/viewed';
import type { Layers } from './layers';
import type { State } from './state';

interface Parts {
  readonly viewport: ViewportPort;
  readonly layers: Pick<Layers, 'markers'>;
  readonly state: State;
  readonly evaluator: Pick<Evaluator, 'result'>;
  readonly host: AppDeformHost;
}

/** @returns the gizmo's drag, for Escape, and the function that ends it all */
export function syncView({ viewport, layers, state, evaluator, host }: Parts): {
  readonly gizmo: GizmoDrag;
  readonly stop: () => void;
} {
  let shown: Evaluation | null = null;
  // A drag moves handles without changing what they hold: their tints need no new upload.
  let drawn: { on: object | null; regions: readonly RegionPaint[] } = { on: null, regions: [] };
  const gizmo = new GizmoDrag(host, () => state.gizmo.peek());
  const vertexLists = new WeakMap<object, Uint32Array>();

  /** Recipes never change in place, so a set is unpacked once. */
  const indices = (set: DeformHandle['vertices'], count: number): Uint32Array => {
    if (typeof set === 'string') return toIndices(set, count);
    const known = vertexLists.get(set);
    if (known) return known;
    const list = toIndices(set, count);
    vertexLists.set(set, list);
    return list;
  };

  const stops = [
    effect(() => {
      const evaluation = evaluator.result.value;
      if (evaluation) show(viewport, evaluation, shown);
      else if (shown) viewport.setModel(null);
      shown = evaluation;
    }),
    effect(() => {
      const evaluation = evaluator.result.value;
      const step = state.step.value;
      const { handle: selected } = state.selection.value;
      if (evaluation?.step.type !== 'deform') drawn = { on: null, regions: [] };
      if (!evaluation || !step || evaluation.step.id !== step.id) return;
      const count = evaluation.input.model.positions.length / 3;
      const stroke = host.paint.value;
      const regions: RegionPaint[] = [];
      const roi =
        stroke?.kind === 'roi' ? stroke.vertices : step.roi === 'all' ? null : indices(step.roi, count);
      if (roi) regions.push({ id: 'roi', tint: 'blue', vertices: roi, visible: true, selected: false });
      const painted = stroke?.kind === 'handle' ? stroke.vertices : null;
      let replaced = false;
      step.handles.forEach((handle, i) => {
        if (handle.kind !== 'region') return;
        const isPainted = painted !== null && i === selected;
        replaced ||= isPainted;
        const vertices = isPainted ? painted : indices(handle.vertices, count);
        const visible = !handle.hidden;
        regions.push({ id: markerId(i), tint: 'violet', vertices, visible, selected: i === selected });
      });
      if (painted && !replaced)
        regions.push({ id: 'stroke', tint: 'violet', vertices: painted, visible: true, selected: true });
      if (drawn.on !== evaluation.input.opened || !sameRegions(drawn.regions, regions)) {
        drawn = { on: evaluation.input.opened, regions };
        viewport.setRegions(regions);
      }
      layers.markers.setMarkers(
        step.handles.flatMap((handle, i) =>
          handle.kind === 'point'
            ? [
                {
                  id: markerId(i),
                  position: handle.position,
                  visible: !handle.hidden,
                  selected: i === selected,
                },
              ]
            : [],
        ),
      );
    }),
    effect(() => {
      const evaluation = evaluator.result.value;
      const step = state.step.value;
      const { handle: index } = state.selection.value;
      const mode = state.gizmo.value;
      // While a gesture lasts the gizmo belongs to the hand that holds it.
      if (state.previewing.value) return;
      const handle = index === null ? undefined : step?.handles[index];
      if (
        !evaluation ||
        !handle ||
        handle.hidden ||
        evaluation.step.id !== step?.id ||
        state.tool.value !== 'select'
      ) {
        viewport.setGizmo(null);
        return;
      }
      const matrix = gizmoFrame(handle, evaluation.input.model.positions);
      viewport.setGizmo({ matrix, mode: handle.kind === 'point' ? 'translate' : mode }, gizmo);
    }),
    effect(() => viewport.setDisplay(state.display.value)),
    effect(() => {
      const lengths = shownLengths(state, evaluator.result.value);
      if (lengths) {
        viewport.setHeat({ values: lengths, range: LENGTHS });
        return;
      }
      const values = state.stretch.value;
      const on = state.heat.value && evaluator.result.value !== null;
      viewport.setHeat(on && values ? { values, range: state.heatRange.value } : null);
    }),
    effect(() => {
      if (!state.tool.value.startsWith('paint-')) viewport.setBrush(null);
    }),
  ];
  return {
    gizmo,
    stop: () => {
      for (const stop of stops) stop();
    },
  };
}

function show(viewport: ViewportPort, next: Evaluation, before: Evaluation | null): void {
  const { model, opened } = next.input;
  // A new worker opens the same model anew: that alone must not end what the hand is doing.
  const isShown =
    before?.input.key === next.input.key &&
    before.input.model.colors === model.colors &&
    before.input.model.upAxis === model.upAxis;
  if (!isShown) {
    const keepCamera = before?.input.model.faceVertices === model.faceVertices;
    viewport.setModel(viewModel(model, opened), { keepCamera });
  }
  viewport.setPositions(next.positions);
  if (next.settled) viewport.settlePositions();
}

const sameRegions = (a: readonly RegionPaint[], b: readonly RegionPaint[]): boolean =>
  a.length === b.length &&
  a.every((region, i) => {
    const other = b[i]!;
    return (
      region.id === other.id &&
      region.vertices === other.vertices &&
      region.visible === other.visible &&
      region.selected === other.selected
    );
  });
