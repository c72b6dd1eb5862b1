// Where a curves step begins: on what the open step leaves.

import * as edit from '../../recipe/edit';
import { newCurvesStep } from '../../recipe/steps/curves';
import { t } from '../i18n';
import type { WingParts } from '../wing-parts';

export function startCurves({
  state,
  document,
  workspaces,
}: Pick<WingParts, 'state' | 'document' | 'workspaces'>) {
  const { recipe } = document;
  const from = workspaces.openModel();
  if (from === undefined) return;
  const id = edit.freeId('curves', recipe);
  document.commit(t('history.curves.start'), edit.addStep(recipe, newCurvesStep(id, from)), {
    step: id,
    item: null,
  });
  state.tool.value = 'sketch-curve';
}
