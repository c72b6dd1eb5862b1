// The model's facts and the status bar's numbers, worked out from each result; each wing publishes its own beside.

import { batch, effect } from '@preact/signals';
import { faceCount, vertexCount } from '../core/model';
import type { StepReport } from '../run/results';
import type { ModelResult } from '../run/types';
import type { Evaluation, EvaluatorPort } from './evaluated';
import type { ModelFacts, State } from './state';

export const factsOf = ({ model, opened }: Pick<ModelResult, 'model' | 'opened'>): ModelFacts => ({
  name: model.name,
  vertices: vertexCount(model),
  faces: faceCount(model),
  components: opened.components,
  boundaryLoops: opened.boundaryLoops,
  closed: opened.closed,
});

/** What the fast half of a step took, in milliseconds. */
export function solveTime(report: StepReport | null): number {
  const { solve = 0, rotate = 0, reconstruct = 0, apply = 0, settle = 0 } = report?.seconds ?? {};
  return 1000 * (solve + rotate + reconstruct + apply + settle);
}

/**
 * @param publish  lets the wings follow, and says which of the findings are news
 * @returns the function that ends it
 */
export function syncFigures(
  state: State,
  { result }: Pick<EvaluatorPort, 'result'>,
  publish: (shown: Evaluation | null) => State['warnings']['value'],
): () => void {
  return effect(() => {
    const evaluation = result.value;
    batch(() => {
      show(state, evaluation);
      state.warnings.value = publish(evaluation);
    });
  });
}

function show(state: State, evaluation: Evaluation | null): void {
  if (!evaluation) {
    state.model.value = null;
    state.facts.value = null;
    return;
  }
  const { shown, report, settled, elapsed } = evaluation;
  const old = state.figures.peek();
  const facts = factsOf(shown);
  if (state.model.peek() !== shown.model) {
    state.model.value = shown.model;
    state.facts.value = facts;
  }
  const { fields = 0, reduce = 0, factor = fields + reduce } = report?.seconds ?? {};
  state.figures.value = {
    ...old,
    vertices: facts.vertices,
    faces: facts.faces,
    free: report && 'free' in report && typeof report.free === 'number' ? report.free : null,
    factor: factor ? 1000 * factor : report ? old.factor : null,
    solve: report && solveTime(report),
    drag: settled ? old.drag : elapsed,
  };
}
