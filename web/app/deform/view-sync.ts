// The deform workspace on screen: regions, handles, gizmo and heat map, one effect per thing drawn, and the tools.

import { effect } from '@preact/signals';
import type { DeformStep } from '../../recipe/recipe';
import type { Paint } from '../../tools/brush-stroke';
import { GizmoDrag, gizmoFrame } from '../../tools/deform/gizmo-drag';
import { markerId } from '../../tools/deform/host';
import { paintHandle, paintRoi } from '../../tools/deform/paint-tool';
import { PointTool } from '../../tools/deform/point-tool';
import { SelectTool } from '../../tools/deform/select-tool';
import { MARKERS } from '../../view/overlays/markers';
import type { RegionPaint, ViewportPort } from '../../view/types';
import type { Evaluation } from '../evaluated';
import { syncMotion } from '../motion-sync';
import { listed, PaintedRegions } from '../painted-regions';
import type { Mounted } from '../wing';
import type { WingParts } from '../wing-parts';
import { AppDeformHost } from './host';
import { syncIsolines } from './isoline-sync';
import type { DeformState } from './state';

type Parts = Pick<WingParts, 'state' | 'document' | 'evaluator' | 'runner' | 'messages'>;

export function mountDeform(viewport: ViewportPort, parts: Parts, own: DeformState): Mounted {
  const { state, evaluator } = parts;
  const markers = viewport.mount(MARKERS);
  const host = new AppDeformHost(viewport, markers.port, parts);
  const gizmo = new GizmoDrag(host, () => own.gizmo.peek());
  const painted = new PaintedRegions(viewport);
  /** What is on screen, while it is of the open step. */
  const open = (): { readonly evaluation: Evaluation; readonly step: DeformStep } | null => {
    const evaluation = evaluator.result.value;
    const step = own.step.value;
    if (evaluation?.step.type !== 'deform' || !step) return null;
    // Steps of another document may have the same id.
    const { id, model } = evaluation.step;
    return id === step.id && model === step.model ? { evaluation, step } : null;
  };
  const stops = [
    syncMotion(viewport, evaluator, own),
    syncIsolines(viewport, parts, own),
    effect(() => {
      const { item: selected } = state.selection.value;
      const stroke = host.paint.value;
      const shown = open();
      if (!shown) return;
      const { evaluation, step } = shown;
      painted.show(evaluation.shown, regionsOf(step, selected, stroke, evaluation));
      markers.port.setMarkers(markersOf(step, selected));
    }),
    effect(() => {
      const shown = open();
      const { item: index } = state.selection.value;
      const mode = own.gizmo.value;
      // While a gesture lasts the gizmo belongs to the hand that holds it.
      if (state.previewing.value) return;
      const handle = index === null ? undefined : shown?.step.handles[index];
      if (!shown || !handle || handle.hidden || state.tool.value !== 'select') {
        viewport.setGizmo(null);
        return;
      }
      const matrix = gizmoFrame(handle, shown.evaluation.shown.model.positions);
      viewport.setGizmo({ matrix, mode: handle.kind === 'point' ? 'translate' : mode }, gizmo);
    }),
    effect(() => {
      const values = own.stretch.value;
      const on = own.heat.value && evaluator.result.value !== null;
      const field = own.field.value;
      if (field) viewport.setHeat(field);
      else viewport.setHeat(on && values ? { values, range: own.heatRange.value } : null);
    }),
  ];
  return {
    tools: {
      select: new SelectTool(host),
      'paint-roi': paintRoi(host),
      'paint-handle': paintHandle(host),
      'point-handle': new PointTool(host),
    },
    cancel: () => {
      gizmo.onCancel();
      return false;
    },
    unmount: () => {
      for (const stop of stops) stop();
      painted.clear();
      markers.unmount();
      viewport.setGizmo(null);
      viewport.setHeat(null);
    },
  };
}

function regionsOf(
  step: DeformStep,
  selected: number | null,
  stroke: Paint | null,
  { shown }: Evaluation,
): RegionPaint[] {
  const count = shown.model.positions.length / 3;
  const regions: RegionPaint[] = [];
  const roi = stroke?.kind === 'roi' ? stroke.vertices : step.roi === 'all' ? null : listed(step.roi, count);
  if (roi) regions.push({ id: 'roi', tint: 'blue', vertices: roi, visible: true, selected: false });
  const painted = stroke?.kind === 'handle' ? stroke.vertices : null;
  let replaced = false;
  step.handles.forEach((handle, i) => {
    if (handle.kind !== 'region') return;
    const isPainted = painted !== null && i === selected;
    replaced ||= isPainted;
    const vertices = isPainted ? painted : listed(handle.vertices, count);
    const visible = !handle.hidden;
    regions.push({ id: markerId(i), tint: 'violet', vertices, visible, selected: i === selected });
  });
  if (painted && !replaced)
    regions.push({ id: 'stroke', tint: 'violet', vertices: painted, visible: true, selected: true });
  return regions;
}

const markersOf = (step: DeformStep, selected: number | null) =>
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
  );
