// What a run leaves: per step its models or strands, what came in, and its line of the report.

import type { Finding } from '../core/errors';
import { faceCount, type Model, vertexCount } from '../core/model';
import type { Strands } from '../core/strands';
import type { Measured } from '../kernel/contract/model';
import type { Recipe, Step, StepType } from '../recipe/recipe';
import { mainReference, outputName, producerOf, referencesOf } from '../recipe/references';
import type { FiguresOf } from './steps/all';
import type { StepOutcome } from './steps/step-runner';
import type { ModelResult } from './types';

/** What every step's line of the report says (RECIPES). */
interface ReportLine<T> {
  readonly id: string;
  readonly type: T;
  readonly vertices: number;
  readonly faces: number;
  /** Of a step that leaves several models: each of them by its name. */
  readonly models?: Readonly<Record<string, { readonly vertices: number; readonly faces: number }>>;
  readonly seconds: Readonly<Record<string, number>>;
  readonly peakBytes: number;
  readonly warnings: readonly Finding[];
}

/** A step's line of the report, with the figures of its type. */
export type ReportOf<T extends StepType> = { [K in T]: ReportLine<K> & FiguresOf<K> }[T];
export type StepReport = ReportOf<StepType>;

export interface StepResult<T extends StepType = StepType> {
  /** What the step leaves in the place of its main input; of a step that grows strands that input as it came in. */
  readonly model: Model;
  /** All that it leaves, by name, where that is several models. */
  readonly models?: Readonly<Record<string, Model>>;
  readonly strands?: Strands;
  /** All that came in, in the order of the step's references. */
  readonly inputs: readonly ModelResult[];
  readonly report: ReportOf<T>;
  readonly measured?: Measured;
}

/** The model that a step changes, among those that came in. */
export const mainOf = (step: Step, inputs: readonly ModelResult[]): ModelResult =>
  inputs[mainReference(step)]!;

/** What a run left under a name that an output may have. */
export function resultNamed(
  recipe: Recipe,
  results: ReadonlyMap<string, StepResult>,
  name: string,
): Pick<StepResult, 'model' | 'strands'> {
  const step = producerOf(recipe, name)!;
  const { model, models, strands } = results.get(step.id)!;
  return { model: models?.[outputName(step, name)] ?? model, ...(strands ? { strands } : {}) };
}

const sizeOf = (model: Model) => ({ vertices: vertexCount(model), faces: faceCount(model) });

/** @param outcome  finished */
export function resultOf(
  recipe: Recipe,
  step: Step,
  inputs: readonly ModelResult[],
  { model, models, strands, figures, seconds, peakBytes, warnings }: StepOutcome,
  measured: Measured | undefined,
): StepResult {
  // What was found in a model is told by the steps that start from it, not again by those that follow.
  const found = referencesOf(step).some(({ name }) => Object.hasOwn(recipe.models, name))
    ? inputs[0]!.opened.findings
    : [];
  const report = {
    id: step.id,
    type: step.type,
    ...sizeOf(model),
    ...(models && { models: mapped(models, sizeOf) }),
    ...figures,
    seconds,
    peakBytes,
    warnings: [...found, ...warnings],
  } as unknown as StepReport;
  return {
    model,
    ...(models && { models }),
    ...(strands && { strands }),
    inputs,
    report,
    ...(measured && { measured }),
  };
}

const mapped = <A, B>(record: Readonly<Record<string, A>>, map: (value: A) => B): Record<string, B> =>
  Object.fromEntries(Object.entries(record).map(([name, value]) => [name, map(value)]));
