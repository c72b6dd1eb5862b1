// Keeps the hair part of the viewport in step with the state: one effect per thing drawn.

import { effect } from '@preact/signals';
import { strandCount } from '../../core/strands';
import { ponytailStage } from '../../tools/hair/ponytail-tool';
import { CURVE_LOOKS, curvesOf } from '../../tools/hair/style';
import type { HairPort } from '../../view/hair/types';
import type { Curve } from '../../view/overlays/types';
import type { ViewportPort } from '../../view/types';
import type { Evaluator } from '../evaluation';
import type { Layers } from '../layers';
import type { State } from '../state';
import type { AppHairHost } from './host';
import { SPARSE } from './lengths';
import { frameHair } from './opening';
import { scalpOf } from './steps';

interface Parts {
  readonly viewport: ViewportPort;
  readonly layers: Layers;
  readonly state: State;
  readonly evaluator: Pick<Evaluator, 'result'>;
  readonly host: AppHairHost;
}

/** Called after the deform workspace's own, which shows the model. @returns the function that ends it */
export function syncHair({ viewport, layers, state, evaluator, host }: Parts): () => void {
  const stops = [
    effect(() => {
      const evaluation = evaluator.result.value;
      const strands = evaluation?.step.type === 'hair' ? evaluation.strands : null;
      if (strands && evaluation?.step.type === 'hair') {
        const grown = Math.max(1, strands.offsets.length - 1);
        layers.hair.setHairOptions({ widthScale: Math.max(1, evaluation.step.strands.count / grown) });
      }
      layers.hair.setHair(strands);
    }),
    thinWhilePainting(layers.hair, state, evaluator),
    frameHair({ viewport, state, evaluator }),
    effect(() => {
      layers.hair.setHairOptions({ show: state.hair.show.value.hair, shading: state.hair.shading.value });
    }),
    effect(() => {
      const step = state.hairStep.value;
      const stroke = state.hair.stroke.value;
      const wanted = state.hair.show.value.curves && !state.hair.viewed.value;
      const shown = step && wanted ? curvesOf(step, state.selection.value.handle) : [];
      const drawn: Curve[] =
        stroke && stroke.line.length > 1
          ? [{ id: 'stroke', points: stroke.line, ...CURVE_LOOKS[stroke.kind], selected: false }]
          : [];
      layers.curves.setCurves([...shown, ...drawn]);
    }),
    effect(() => {
      const surface = host.surface.value;
      const shown = state.hair.show.value.support && isEditing(state) && !state.hair.viewed.value;
      layers.support.setSupport(surface && shown ? surface : null);
    }),
    effect(() => {
      const evaluation = evaluator.result.value;
      const step = state.hairStep.value;
      const painted = host.paint.value;
      if (evaluation?.step.type !== 'hair' || !step) return;
      const vertices = painted ?? scalpOf(step, evaluation.input.model);
      const shown = state.tool.value === 'paint-scalp' || state.tool.value === 'paint-length';
      layers.markers.setMarkers([]);
      viewport.setRegions(
        shown ? [{ id: 'scalp', tint: 'green', vertices, visible: true, selected: true }] : [],
      );
    }),
  ];
  return () => {
    for (const stop of stops) stop();
  };
}

/** Colours on the scalp are of no use under a full head of hair. */
function thinWhilePainting(hair: HairPort, state: State, { result }: Pick<Evaluator, 'result'>): () => void {
  let thin = false;
  return effect(() => {
    const shown = result.value;
    const painting = state.tool.value === 'paint-length' && shown?.strands;
    if (!painting && !thin) return;
    thin = Boolean(painting);
    hair.setStrandShare(painting ? Math.min(1, SPARSE / Math.max(1, strandCount(painting))) : null);
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
