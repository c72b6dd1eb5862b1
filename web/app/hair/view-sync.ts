// Keeps the hair part of the viewport in step with the state: one effect per thing drawn.

import { effect } from '@preact/signals';
import { strandCount } from '../../core/strands';
import { scalpOf } from '../../run/steps/hair/scalp';
import { ponytailStage } from '../../tools/hair/ponytail-tool';
import { curvesOf } from '../../tools/hair/style';
import type { StyleCurve } from '../../view/hair/types';
import type { ViewportPort } from '../../view/types';
import type { Evaluator } from '../evaluation';
import type { State } from '../state';
import type { AppHairHost } from './host';
import { SPARSE } from './lengths';
import { frameHair } from './opening';

interface Parts {
  readonly viewport: ViewportPort;
  readonly state: State;
  readonly evaluator: Pick<Evaluator, 'result'>;
  readonly host: AppHairHost;
}

/** Called after the deform workspace's own, which shows the model. @returns the function that ends it */
export function syncHair({ viewport, state, evaluator, host }: Parts): () => void {
  const stops = [
    effect(() => {
      const evaluation = evaluator.result.value;
      const strands = evaluation?.step.type === 'hair' ? evaluation.strands : null;
      if (strands && evaluation?.step.type === 'hair') {
        const grown = Math.max(1, strands.offsets.length - 1);
        viewport.setHairOptions({ widthScale: Math.max(1, evaluation.step.strands.count / grown) });
      }
      viewport.setHair(strands);
    }),
    thinWhilePainting(viewport, state, evaluator),
    frameHair({ viewport, state, evaluator }),
    effect(() => {
      viewport.setHairOptions({ show: state.hair.show.value.hair, shading: state.hair.shading.value });
    }),
    effect(() => {
      const step = state.hairStep.value;
      const stroke = state.hair.stroke.value;
      const wanted = state.hair.show.value.curves && !state.hair.viewed.value;
      const shown = step && wanted ? curvesOf(step, state.selection.value.handle) : [];
      const drawn: StyleCurve[] =
        stroke && stroke.line.length > 1
          ? [{ id: 'stroke', points: stroke.line, kind: stroke.kind, selected: false }]
          : [];
      viewport.setCurves([...shown, ...drawn]);
    }),
    effect(() => {
      const surface = host.surface.value;
      const shown = state.hair.show.value.support && isEditing(state) && !state.hair.viewed.value;
      viewport.setSupport(surface && shown ? surface : null);
    }),
    effect(() => {
      const evaluation = evaluator.result.value;
      const step = state.hairStep.value;
      const painted = host.paint.value;
      if (evaluation?.step.type !== 'hair' || !step) return;
      const vertices = painted ?? scalpOf(step, evaluation.input.model);
      const shown = state.tool.value === 'paint-scalp' || state.tool.value === 'paint-length';
      viewport.setMarkers([]);
      viewport.setRegions(
        shown ? [{ id: 'scalp', kind: 'scalp', vertices, visible: true, selected: true }] : [],
      );
    }),
  ];
  return () => {
    for (const stop of stops) stop();
  };
}

/** Colours on the scalp are of no use under a full head of hair. */
function thinWhilePainting(
  viewport: ViewportPort,
  state: State,
  { result }: Pick<Evaluator, 'result'>,
): () => void {
  let thin = false;
  return effect(() => {
    const shown = result.value;
    const painting = state.tool.value === 'paint-length' && shown?.strands;
    if (!painting && !thin) return;
    thin = Boolean(painting);
    viewport.setStrandShare(painting ? Math.min(1, SPARSE / Math.max(1, strandCount(painting))) : null);
  });
}

/** Whether strokes land on the supporting surface now. */
function isEditing(state: State): boolean {
  if (state.tool.value === 'hint') return true;
  const step = state.hairStep.value;
  const selected = state.selection.value.handle;
  return (
    state.tool.value === 'ponytail' && step !== undefined && ponytailStage({ step, selected }) !== 'spine'
  );
}
