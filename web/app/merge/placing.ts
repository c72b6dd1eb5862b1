// How the two marked patches lie on each other in the plane, where the best line between them is sought.

import { LissomError } from '../../core/errors';
import { replaceStep } from '../../recipe/edit';
import type { Answer } from '../../run/steps/all';
import { t } from '../i18n';
import type { WingParts } from '../wing-parts';
import type { MergeEdits } from './edits';
import { isReady, type OptimalBoundary } from './steps';

export type RegionMaps = Answer<'maps'>;

export class Placing {
  constructor(
    private readonly edits: MergeEdits,
    private readonly parts: Pick<WingParts, 'document' | 'runner'>,
  ) {}

  /** How the part's map lies on the target's; `undefined`: found again. */
  setPlacement(placement: OptimalBoundary['placement']): void {
    const { step } = this.edits;
    if (!step?.optimalBoundary) return;
    const { placement: _, ...marks } = step.optimalBoundary;
    const optimalBoundary = placement ? { ...marks, placement } : marks;
    this.edits.commit(t('history.merge.placement'), { ...step, optimalBoundary });
  }

  /** The two plane maps, the part's not placed yet; `null` where the marks allow none. */
  async maps(): Promise<RegionMaps | null> {
    const { document, runner } = this.parts;
    const { step } = this.edits;
    if (!step?.optimalBoundary || !isReady(step)) return null;
    const { placement: _, ...marks } = step.optimalBoundary;
    try {
      const recipe = replaceStep(document.recipe, { ...step, optimalBoundary: marks });
      return await runner.ask(recipe, step.id, 'maps', {});
    } catch (error) {
      // What is wrong with the marks is told where they are merged.
      if (error instanceof LissomError) return null;
      throw error;
    }
  }
}
