// What a hairstyle looks like at first sight: the hair itself, whole, without the curves it follows.

import { effect } from '@preact/signals';
import type { ViewportPort } from '../../view/types';
import type { Evaluator } from '../evaluation';
import { type State, TOOLS } from '../state';

const [LOOKS_ON] = TOOLS.hair;

/**
 * Hides the curves of whatever is laid open, until one is selected or a tool is in hand that works on them.
 * @returns the function that ends it
 */
export function hideCurvesAtFirst(state: State): () => void {
  let opened = state.opened.peek();
  return effect(() => {
    const isNew = opened !== state.opened.value;
    opened = state.opened.value;
    const wanted = state.selection.value.handle !== null || draws(state);
    const show = state.hair.show.peek();
    if (isNew ? show.curves : wanted && !show.curves) state.hair.show.value = { ...show, curves: !isNew };
  });
}

function draws(state: State): boolean {
  const tool = state.tool.value;
  return state.workspace.value === 'hair' && tool !== LOOKS_ON && !tool.startsWith('paint-');
}

interface Parts {
  readonly viewport: Pick<ViewportPort, 'fit' | 'setView'>;
  readonly state: Pick<State, 'opened' | 'previewing'>;
  readonly evaluator: Pick<Evaluator, 'result'>;
}

/**
 * Frames head and hair once the first strands of a newly opened style are there, from where the person looks by
 * then. Called after what shows the model and the strands. @returns the function that ends it
 */
export function frameHair({ viewport, state, evaluator }: Parts): () => void {
  let opened = -1;
  let surface: Uint32Array | null = null;
  let waits = false;
  return effect(() => {
    const evaluation = evaluator.result.value;
    if (!evaluation) {
      surface = null;
      return;
    }
    const { faceVertices } = evaluation.input.model;
    const isHair = evaluation.step.type === 'hair';
    if (surface !== faceVertices || opened !== state.opened.peek()) {
      // The same head under another style: it has not been shown anew, so the camera still stands anywhere.
      if (isHair && surface === faceVertices) viewport.setView('home');
      surface = faceVertices;
      opened = state.opened.peek();
      waits = isHair;
    }
    if (!waits || (!evaluation.strands && !evaluation.settled)) return;
    waits = false;
    if (evaluation.strands && !state.previewing.peek()) viewport.fit();
  });
}
