// The curves workspace on screen: lines, regions and gizmo, one effect per thing drawn, and the tools.

import { effect } from '@preact/signals';
import { pointsOf } from '../../recipe/steps/curves-edits';
import { jointOf } from '../../tools/curves/edits';
import { type CurveGizmo, CurveGizmoDrag, gizmoFrame } from '../../tools/curves/gizmo-drag';
import { LinkTool } from '../../tools/curves/link-tool';
import { PoseTool } from '../../tools/curves/pose-tool';
import { SketchTool } from '../../tools/curves/sketch-tool';
import { splinePoints } from '../../tools/curves/spline';
import { IDENTITY, transform } from '../../tools/geometry';
import { INNER_LINES } from '../../view/overlays/control-lines';
import type { ControlLine } from '../../view/overlays/types';
import type { GizmoMode, RegionPaint, ViewportPort } from '../../view/types';
import { syncMotion } from '../motion-sync';
import { PaintedRegions } from '../painted-regions';
import type { Mounted } from '../wing';
import type { WingParts } from '../wing-parts';
import type { CurvesActions } from './actions';
import { mountContours } from './contours/view-sync';
import { AppCurvesHost } from './host';
import { PosePictures } from './pose-pictures';
import type { CurvesState } from './state';

type Parts = Pick<WingParts, 'state' | 'document' | 'evaluator' | 'runner' | 'messages'>;

const GIZMO: Readonly<Record<CurveGizmo, GizmoMode | null>> = {
  move: 'translate',
  turn: 'rotate',
  twist: 'rotate',
  scale: 'scale',
  end: null,
};

export function mountCurves(
  viewport: ViewportPort,
  parts: Parts,
  own: CurvesState,
  actions: CurvesActions,
): Mounted {
  const { state, evaluator } = parts;
  const lines = viewport.mount(INNER_LINES);
  const host = new AppCurvesHost(viewport, lines.port, parts, own, actions.edits);
  const gizmo = new CurveGizmoDrag(host, () => own.gizmo.peek());
  const painted = new PaintedRegions(viewport);
  const pictures = new PosePictures(viewport, parts, own);
  const stops = [
    effect(() =>
      lines.port.setLines(own.contours.on.value ? [] : [...curvesShown(own), ...strokeShown(own)]),
    ),
    syncMotion(viewport, evaluator, own),
    effect(() => {
      const evaluation = evaluator.result.value;
      const step = own.step.value;
      if (!step || evaluation?.step.id !== step.id) {
        painted.clear();
        return;
      }
      painted.show(evaluation.shown, own.contours.on.value ? [] : regionsShown(own));
    }),
    effect(() => {
      const grip = own.grip.value;
      const gizmoMode = own.gizmo.value;
      const mode = GIZMO[gizmoMode];
      const step = own.step.value;
      const prepared = own.prepared.value;
      const parents = own.parents.value;
      // While a gesture lasts the gizmo belongs to the hand that holds it.
      if (state.previewing.value) return;
      // A whole curve is dragged by its line; only a turn has to be taken hold of elsewhere.
      const held = grip && (grip.point !== null || gizmoMode === 'turn');
      const shown = held && step && mode && state.tool.value === 'pose-curves';
      const anchors = step?.curves.map(({ anchor }, i) => anchor ?? prepared?.curves[i]?.anchor ?? 'start');
      const matrix = shown
        ? gizmoFrame({ step, selected: grip, parents, anchors: anchors!, size: 1 }, grip)
        : null;
      viewport.setGizmo(matrix && mode && { matrix, mode, single: gizmoMode === 'twist' }, gizmo);
    }),
  ];
  const contours = mountContours(viewport, parts, own, actions.hand);
  return {
    tools: {
      'pose-curves': new PoseTool(host),
      'sketch-curve': new SketchTool(host),
      'link-curves': new LinkTool(host),
      contours: contours.tool,
    },
    cancel: () => {
      gizmo.onCancel();
      return actions.player.stop();
    },
    unmount: () => {
      actions.player.stop();
      for (const stop of stops) stop();
      own.under.value = null;
      pictures.dispose();
      contours.unmount();
      painted.clear();
      lines.unmount();
      viewport.setGizmo(null);
    },
  };
}

/** Reads signals. */
function curvesShown(own: CurvesState): ControlLine[] {
  const step = own.step.value;
  const grip = own.grip.value;
  const parents = own.parents.value;
  const hidden = own.hidden.value;
  const under = own.under.value;
  return (step?.curves ?? []).flatMap((curve, i): ControlLine[] => {
    if (hidden.has(curve.id)) return [];
    const matrix = parents[i] ?? IDENTITY;
    const points = pointsOf(curve).map((point) => transform(matrix, point));
    const selected = grip?.curve === i;
    return [
      {
        id: curve.id,
        points,
        smooth: splinePoints(points, curve.rigid),
        tint: curve.kind === 'skeleton' ? 'violet' : 'cyan',
        selected,
        chosen: selected && grip.point !== null ? grip.point : undefined,
        joints: jointOf(step!, i) ? [0] : [],
        under: under?.curve === i ? (under.point ?? 'line') : undefined,
      },
    ];
  });
}

/** Reads signals. */
function strokeShown({ stroke, foreseen }: CurvesState): ControlLine[] {
  const line = (id: string, points: ControlLine['points'], tint: ControlLine['tint']): ControlLine => ({
    id,
    points,
    tint,
    selected: id === 'foreseen',
    plain: true,
  });
  return [
    ...(stroke.value ? [line('stroke', stroke.value, 'coral')] : []),
    ...(foreseen.value ? [line('foreseen', foreseen.value, 'violet')] : []),
  ];
}

/** Reads signals. */
function regionsShown(own: CurvesState): RegionPaint[] {
  const grip = own.grip.value;
  const reached = own.reached.value;
  const region = reached ?? (grip && own.prepared.value?.curves[grip.curve]?.region);
  const crossing = own.crossing.value;
  const paint = (id: string, tint: RegionPaint['tint'], vertices: Uint32Array): RegionPaint => ({
    id,
    tint,
    vertices,
    visible: true,
    selected: false,
  });
  return [
    ...(region && region.length > 0 ? [paint('region', 'blue', region)] : []),
    ...(crossing && crossing.length > 0 ? [paint('crossing', 'red', crossing)] : []),
  ];
}
