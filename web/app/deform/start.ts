// Where a deform step begins, and which of several is meant.

import * as edit from '../../recipe/edit';
import { type Recipe, stepRow } from '../../recipe/recipe';
import { mainInput } from '../../recipe/references';
import { newDeformStep } from '../../recipe/steps/deform';
import { t } from '../i18n';
import type { BareModel } from '../wing';
import type { WingParts } from '../wing-parts';
import { lastOf } from '../workspaces';

/** A new recipe on a model: one step, nothing held yet. */
export function openingRecipe({ name, ref }: BareModel): Recipe {
  const id = edit.uniqueName('deform 1', [name]);
  return { lissom: 1, models: { [name]: ref }, steps: [newDeformStep(id, name)], outputs: [] };
}

/**
 * The last deform step. What makes a surface of its own is deformed as a whole: deform steps before it are opened from
 * the list of steps.
 */
export function lastDeform({ steps }: Recipe, open: string | undefined): string | undefined {
  const at = steps.findIndex(({ id, type }) => id === open && stepRow(type).writes === 'mesh');
  return lastOf({ steps: steps.slice(at + 1) }, 'deform');
}

/** A new step after the open one; where that one grows on the surface, before it, so that it follows the shape. */
export function startDeform({ document, workspaces }: Pick<WingParts, 'document' | 'workspaces'>): void {
  const { recipe, selection } = document;
  const open = edit.stepById(recipe, selection.step);
  if (!open) return;
  const id = edit.freeId('deform', recipe);
  const { writes, main } = stepRow(open.type);
  const steps =
    writes === 'strands'
      ? recipe.steps.flatMap((step) =>
          step === open ? [newDeformStep(id, mainInput(open)), { ...open, [main]: id }] : [step],
        )
      : [...recipe.steps, newDeformStep(id, writes === 'mesh' ? open.id : workspaces.openModel()!)];
  document.commit(t('history.deform.start'), { ...recipe, steps }, { step: id, item: null });
}
