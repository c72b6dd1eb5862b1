// Where hair begins: on the open model where it has a scalp, else on a head of the gallery's.

import * as edit from '../../recipe/edit';
import type { Recipe } from '../../recipe/recipe';
import { newHairStep } from '../../recipe/steps/hair';
import { scalpOf } from '../../run/steps/hair/scalp';
import { primitivesOf } from '../../tools/hair/style';
import { t } from '../i18n';
import type { WingParts } from '../wing-parts';

/** The head that hair starts on where the open model has no scalp. */
const HEAD = 'head-female';

type Parts = Pick<WingParts, 'state' | 'document' | 'desk' | 'evaluator' | 'messages' | 'workspaces'>;

/** A new recipe of hair on a built-in head: nothing drawn yet. */
export const hairRecipeOn = (builtin: string): Recipe => ({
  lissom: 1,
  models: { [builtin]: { builtin } },
  steps: [newHairStep('hair 1', builtin)],
  outputs: [],
});

export async function startHair(parts: Parts): Promise<void> {
  const { state, document, desk, evaluator, messages, workspaces } = parts;
  const { recipe } = document;
  const open = evaluator.result.peek();
  const from = workspaces.openModel();
  const id = edit.freeId('hair', recipe);
  if (open && from !== undefined && scalpOf({}, open.shown.model).length > 0) {
    const grown = edit.addStep(recipe, newHairStep(id, from));
    document.commit(t('history.hair.start'), grown, { step: id, item: null });
  } else if (document.isDirty) {
    // Somebody's work: the head joins it, and undo takes it out again.
    const name = HEAD in recipe.models ? HEAD : edit.uniqueName(HEAD, edit.takenNames(recipe));
    const joined = edit.addStep(edit.setModel(recipe, name, { builtin: HEAD }), newHairStep(id, name));
    document.commit(t('history.hair.start'), joined, { step: id, item: null });
    const label = t('toast.hair-here');
    const run = () => growOn(parts, from!, id);
    messages.toast('info', t('toast.hair-head'), from === undefined ? undefined : { label, run });
  } else {
    await desk.open({ recipe: hairRecipeOn(HEAD), title: HEAD });
    if (open) messages.toast('info', t('toast.hair-head'));
  }
  state.tool.value = 'stream';
}

/**
 * A hair step on a model whose scalp is to be painted.
 * @param offered  a hair step that this one takes the place of, unless something is drawn in it
 */
export function growOn(
  { document, state }: Pick<Parts, 'document' | 'state'>,
  from: string,
  offered: string,
): void {
  const step = edit.stepOf(document.recipe, offered, 'hair');
  const unused = step && primitivesOf(step).length === 0;
  const recipe = unused ? edit.pruneModels(edit.removeStep(document.recipe, step.id)) : document.recipe;
  const id = edit.freeId('hair', recipe);
  const grown = edit.addStep(recipe, { ...newHairStep(id, from), scalp: [] });
  document.commit(t('history.hair.start'), grown, { step: id, item: null });
  state.tool.value = 'paint-scalp';
}
