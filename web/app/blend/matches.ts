// Which match a blend begins with, and what its models are called.

import { stepsOf } from '../../recipe/edit';
import type { MatchStep, Recipe } from '../../recipe/recipe';

/** The open one, else the last. */
export const matchFor = (recipe: Recipe, open: string): MatchStep | undefined => {
  const matches = stepsOf(recipe, 'match');
  return matches.find(({ id }) => id === open) ?? matches.at(-1);
};

/** What a model is called among those of a match: its own name, without the steps that it came through. */
export const shortName = (name: string): string => name.slice(name.lastIndexOf('/') + 1);
