// The blend workspace on screen: the shape, its parts tinted, tapes where it is measured.

import { effect } from '@preact/signals';
import type { BlendMeasure } from '../../recipe/steps/blend';
import { LengthTool } from '../../tools/blend/length-tool';
import { girthTool, PART, paintPart, pickPart } from '../../tools/blend/part-tool';
import { sectionLoop } from '../../tools/blend/section';
import { pointAt } from '../../tools/geometry';
import { CONTROL_LINES } from '../../view/overlays/control-lines';
import { LOOPS } from '../../view/overlays/loops';
import type { ControlLine, LoopLine } from '../../view/overlays/types';
import type { Tint } from '../../view/palette';
import type { RegionPaint, ViewportPort } from '../../view/types';
import { syncMotion } from '../motion-sync';
import { listed, PaintedRegions } from '../painted-regions';
import type { Mounted } from '../wing';
import type { WingParts } from '../wing-parts';
import type { BlendActions } from './actions';
import { AppBlendHost } from './host';
import { syncPictures } from './skin-pictures';
import type { BlendState } from './state';

/** Of the parts, one after the other. */
export const PART_TINTS = ['violet', 'yellow', 'red', 'azure'] as const satisfies readonly Tint[];

type Parts = Pick<WingParts, 'state' | 'document' | 'evaluator' | 'messages'>;

export function mountBlend(
  viewport: ViewportPort,
  parts: Parts,
  own: BlendState,
  actions: BlendActions,
): Mounted {
  const host = new AppBlendHost(viewport, parts, actions, own);
  const painted = new PaintedRegions(viewport);
  const loops = viewport.mount(LOOPS);
  const lines = viewport.mount(CONTROL_LINES);
  const stops = [
    syncMotion(viewport, parts.evaluator, own),
    syncPictures(viewport, parts, own),
    effect(() => showParts(painted, host, parts, own)),
    effect(() => loops.port.setLoops(tapes(parts, own))),
    effect(() => lines.port.setLines(lengths(parts, own, actions))),
    effect(() => {
      if (parts.state.tool.value !== 'paint-part') viewport.setBrush(null);
      if (parts.state.tool.value !== 'measure-length' || !own.step.value) own.length.value = null;
    }),
  ];
  return {
    tools: {
      'pick-part': pickPart(host),
      'paint-part': paintPart(host),
      'measure-girth': girthTool(host),
      'measure-length': new LengthTool(host),
    },
    unmount: () => {
      for (const stop of stops) stop();
      painted.clear();
      loops.unmount();
      lines.unmount();
    },
  };
}

function showParts(
  painted: PaintedRegions,
  host: AppBlendHost,
  { state, evaluator }: Parts,
  own: BlendState,
): void {
  const step = own.step.value;
  const stroke = host.paint.value;
  const evaluation = evaluator.result.value;
  const { item } = state.selection.value;
  if (!step || evaluation?.step.id !== step.id || !evaluation.report) {
    painted.clear();
    return;
  }
  const count = evaluation.shown.model.positions.length / 3;
  const region = (index: number, vertices: Uint32Array): RegionPaint => ({
    id: String(index),
    tint: PART_TINTS[index % PART_TINTS.length]!,
    vertices,
    visible: true,
    selected: index === item,
  });
  const regions = step.parts.map(({ vertices }, index) =>
    region(index, stroke?.kind === PART && index === item ? stroke.vertices : listed(vertices, count)),
  );
  const isNew = stroke?.kind === PART && (item === null || !step.parts[item]);
  painted.show(evaluation.shown, isNew ? [...regions, region(step.parts.length, stroke.vertices)] : regions);
}

/** Where girths are measured on the shape as it is; none while it moves. */
function tapes({ evaluator }: Parts, own: BlendState): LoopLine[] {
  const step = own.step.value;
  const evaluation = evaluator.result.value;
  if (!step || evaluation?.step.id !== step.id || !evaluation.report || evaluation.moved) return [];
  const { positions, shown } = evaluation;
  return step.measures.flatMap((measure): LoopLine[] => {
    const points = tapeOf(measure, positions, shown.opened.triangles);
    return points ? [{ points, tint: 'green', strong: measure.value !== undefined }] : [];
  });
}

/** Lengths on the shape as it is, and the one under way; none while it moves. */
function lengths({ evaluator }: Parts, own: BlendState, { measuring }: BlendActions): ControlLine[] {
  const step = own.step.value;
  const begun = own.length.value;
  const evaluation = evaluator.result.value;
  if (!step || evaluation?.step.id !== step.id || !evaluation.report || evaluation.moved) return [];
  const { positions } = evaluation;
  const line = (id: string, path: readonly number[], look: Pick<ControlLine, 'tint' | 'selected'>) => {
    const smooth = path.filter((v) => 3 * v < positions.length).map((v) => pointAt(positions, v));
    return smooth.length > 0 ? [{ id, points: [smooth[0]!, smooth.at(-1)!], smooth, ...look }] : [];
  };
  const measured = step.measures.flatMap((measure, index) =>
    measure.kind === 'length'
      ? line(String(index), measure.path, { tint: 'green', selected: measure.value !== undefined })
      : [],
  );
  if (!begun) return measured;
  const { from, to, straight } = begun;
  const path = to === null ? [from] : (measuring.pathOf({ from, to, straight }) ?? [from]);
  return [...measured, ...line('begun', path, { tint: 'cyan', selected: true })];
}

function tapeOf(measure: BlendMeasure, positions: Float64Array, triangles: Uint32Array): Float64Array | null {
  if (measure.kind !== 'girth') return null;
  const { vertex, normal, loop } = measure;
  if (vertex !== undefined)
    return 3 * vertex < positions.length ? sectionLoop(positions, triangles, vertex, normal) : null;
  return loop ? Float64Array.from(loop.flatMap((v) => [...positions.subarray(3 * v, 3 * v + 3)])) : null;
}
