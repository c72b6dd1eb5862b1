// Pure edits of a blend step's parts and measures.

import { fromIndices, holds, isEmpty, toIndices } from '../../core/vertex-set';
import type { BlendMeasure, BlendPart, BlendStep } from '../../recipe/steps/blend';

/** Number of the last part that holds a vertex: it lies over the others; −1 if none does. */
export const partAt = ({ parts }: Pick<BlendStep, 'parts'>, vertex: number): number =>
  parts.findLastIndex(({ vertices }) => holds(vertices, vertex));

/** The step whose part is exactly these vertices; without any it is gone. */
export function withVertices(
  step: BlendStep,
  index: number,
  vertices: Uint32Array,
  count: number,
): BlendStep {
  const set = fromIndices(vertices, count);
  if (isEmpty(set)) return withoutPart(step, index);
  return withPart(step, index, { vertices: set });
}

export const withPart = (step: BlendStep, index: number, change: Partial<BlendPart>): BlendStep => ({
  ...step,
  parts: step.parts.map((part, i) => (i === index ? { ...part, ...change } : part)),
});

export const withoutPart = (step: BlendStep, index: number): BlendStep => ({
  ...step,
  parts: step.parts.filter((_, i) => i !== index),
});

export const addedPart = (step: BlendStep, part: BlendPart): BlendStep => ({
  ...step,
  parts: [...step.parts, part],
});

export const partVertices = ({ vertices }: Pick<BlendPart, 'vertices'>, count: number): Uint32Array =>
  toIndices(vertices, count);

export const withMeasure = (step: BlendStep, index: number, measure: BlendMeasure): BlendStep => ({
  ...step,
  measures: step.measures.map((each, i) => (i === index ? measure : each)),
});

export const withoutMeasure = (step: BlendStep, index: number): BlendStep => ({
  ...step,
  measures: step.measures.filter((_, i) => i !== index),
});

export const addedMeasures = (step: BlendStep, measures: readonly BlendMeasure[]): BlendStep => ({
  ...step,
  measures: [...step.measures, ...measures],
});

/** The measure that is only measured, or is wanted to be so much. */
export function wanting(measure: BlendMeasure, value: number | undefined): BlendMeasure {
  const { value: _before, ...rest } = measure;
  return value === undefined ? rest : { ...rest, value };
}
