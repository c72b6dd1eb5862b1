// What a hairstyle looks like at first sight: the hair itself, whole, without the curves it follows.

import { effect } from '@preact/signals';
import type { ViewportPort } from '../../view/types';
import type { EvaluatorPort } from '../evaluated';
import type { State } from '../state';
import { TOOLS } from './commands';
import type { HairState } from './state';

const [LOOKS_ON] = TOOLS;

/**
 * Hides the curves of whatever is laid open, until one is selected or a tool is in hand that works on them.
 * @returns the function that ends it
 */
export function hideCurvesAtFirst(state: State, own: Pick<HairState, 'show'>): () => void {
  let opened = -1;
  return effect(() => {
    const isNew = opened !== state.opened.value;
    opened = state.opened.value;
    const wanted = state.selection.value.item !== null || draws(state);
    const show = own.show.peek();
    if (isNew ? show.curves : wanted && !show.curves) own.show.value = { ...show, curves: !isNew };
  });
}

function draws(state: State): boolean {
  const tool = state.tool.value;
  return tool !== LOOKS_ON && !tool.startsWith('paint-') && (TOOLS as readonly string[]).includes(tool);
}

interface Parts {
  readonly viewport: Pick<ViewportPort, 'fit' | 'setView'>;
  readonly state: Pick<State, 'opened' | 'previewing'>;
  readonly evaluator: Pick<EvaluatorPort, 'result'>;
}

/** What has been framed already: it outlives the closing of the workspace. */
export class FirstSight {
  opened = -1;
  surface: Uint32Array | null = null;
  waits = false;
}

/**
 * Frames head and hair once the first strands of a newly opened style are there, from where the person looks by
 * then. Called after what shows the model and the strands. @returns the function that ends it
 */
export function frameHair({ viewport, state, evaluator }: Parts, sight = new FirstSight()): () => void {
  return effect(() => {
    const evaluation = evaluator.result.value;
    if (!evaluation) {
      sight.surface = null;
      return;
    }
    const { faceVertices } = evaluation.shown.model;
    const isHair = evaluation.step.type === 'hair';
    if (sight.surface !== faceVertices || sight.opened !== state.opened.peek()) {
      // The same head under another style: it has not been shown anew, so the camera still stands anywhere.
      if (isHair && sight.surface === faceVertices) viewport.setView('home');
      sight.surface = faceVertices;
      sight.opened = state.opened.peek();
      sight.waits = isHair;
    }
    if (!sight.waits || (!evaluation.strands && !evaluation.settled)) return;
    sight.waits = false;
    if (evaluation.strands && !state.previewing.peek()) viewport.fit();
  });
}
