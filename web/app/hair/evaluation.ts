// Hair from a recipe: what has to be grown anew and what has not.

import { hairColor } from '../../core/melanin';
import type { Strands } from '../../core/strands';
import type { HairStep, Recipe } from '../../recipe/recipe';
import { newHairStep } from '../../recipe/steps/hair';
import type { RunOptions } from '../../run/evaluate';
import type { ModelResult, StepReport } from '../../run/types';
import type { RunnerPort } from '../evaluation';
import { scalpOf, withHairStep } from './steps';

export interface GrownStep {
  readonly input: ModelResult;
  readonly positions: Float64Array;
  readonly strands: Strands | null;
  readonly report: StepReport | null;
}

const PLAIN = newHairStep('plain', 'plain').material;

/**
 * Runs a hair step. Its look is put on afterwards, so that a change of colour finds the strands as they are.
 * A head whose scalp is still to be painted is only opened.
 */
export async function runHair(
  runner: RunnerPort,
  recipe: Recipe,
  step: HairStep,
  options: RunOptions,
): Promise<GrownStep> {
  const { signal } = options;
  const input = await runner.input(recipe, step.id, signal ? { signal } : {});
  const { positions } = input.model;
  if (scalpOf(step, input.model).length === 0) return { input, positions, strands: null, report: null };
  const plain = withHairStep(recipe, { ...step, material: PLAIN });
  const results = await runner.run(plain, { ...options, until: step.id });
  const { report, strands } = results.get(step.id)!;
  return { input, positions, strands: strands ? withLook(strands, step.material) : null, report };
}

/** @param strands  grown with the plain look, whose thickness follows the head */
export function withLook(strands: Strands, material: HairStep['material']): Strands {
  const { color, melanin, redness, colorVariation, thickness, taper } = material;
  const look = {
    color: color?.toLowerCase() ?? hairColor(melanin, redness),
    colorVariation,
    thickness: thickness ?? strands.look.thickness,
    taper,
  };
  return { ...strands, look };
}

/** Whether two states of a step grow the same strands, field for field: only look, names and the like differ. */
export function growsAlike(a: HairStep, b: HairStep): boolean {
  return (
    a.id === b.id &&
    a.model === b.model &&
    a.scalp === b.scalp &&
    a.grid === b.grid &&
    a.streams === b.streams &&
    a.partings === b.partings &&
    a.ponytails === b.ponytails &&
    a.strands === b.strands &&
    a.length === b.length &&
    a.volume === b.volume &&
    a.detail === b.detail
  );
}

/** Whether both are of one head: the field is prepared for it once. */
export const sameHead = (a: HairStep, b: HairStep): boolean =>
  a.id === b.id && a.model === b.model && a.scalp === b.scalp && a.grid.resolution === b.grid.resolution;
