import type { Finding } from '../core/errors';
import { faceCount, vertexCount } from '../core/model';
import type { ImportNote } from '../io/notes';
import { formatJson } from '../recipe/format';
import { RECIPE_VERSION, type Recipe } from '../recipe/recipe';
import { referencesOf } from '../recipe/references';
import type { StepResult } from '../run/results';
import type { ModelResult } from '../run/types';

interface ModelReport {
  readonly vertices: number;
  readonly faces: number;
  readonly components: number;
  readonly boundaryLoops: number;
  readonly closed: boolean;
  /** What the reader and the kernel found, and whether it was repaired. */
  readonly findings: readonly Finding[];
}

/** The report of a run: what came in, and one entry per step in the order of the recipe. */
export function reportOf(
  recipe: Recipe,
  results: ReadonlyMap<string, StepResult>,
  notes: ReadonlyMap<string, readonly ImportNote[]>,
): string {
  const models: Record<string, ModelReport> = {};
  for (const step of recipe.steps) {
    for (const [at, { name }] of referencesOf(step).entries())
      if (Object.hasOwn(recipe.models, name))
        models[name] = modelReport(results.get(step.id)!.inputs[at]!, notes.get(name) ?? []);
  }
  const steps = recipe.steps.map(({ id }) => results.get(id)!.report);
  return `${formatJson({ lissom: RECIPE_VERSION, models, steps })}\n`;
}

function modelReport({ model, opened }: ModelResult, notes: readonly ImportNote[]): ModelReport {
  return {
    vertices: vertexCount(model),
    faces: faceCount(model),
    components: opened.components,
    boundaryLoops: opened.boundaryLoops,
    closed: opened.closed,
    findings: [...notes, ...opened.findings],
  };
}
