// What the workspace shows beside the result follows it: the body it was made for, what else is worn, what it took.

import { isCancelled } from '../../core/errors';
import type { DressStep, Recipe } from '../../recipe/recipe';
import type { ReportOf } from '../../run/results';
import type { Evaluation } from '../evaluated';
import { NewestWork } from '../newest-work';
import { problemText } from '../problem-text';
import type { WingParts } from '../wing-parts';
import type { DressFigures, DressState, Worn } from './state';

export class Follow {
  readonly #work: NewestWork;
  /** Whose other garments are on screen. */
  #wearer: string | undefined;

  constructor(
    private readonly own: DressState,
    private readonly parts: Pick<WingParts, 'runner' | 'messages'>,
  ) {
    this.#work = new NewestWork(parts.messages);
  }

  publish(shown: Evaluation | null): void {
    const { own } = this;
    this.#work.end();
    own.figures.value = shown && figuresOf(shown);
    own.problem.value = problemText(shown, 'dress.problem.');
    const wearer = shown?.step.type === 'dress' ? shown.step.to : undefined;
    // On another body they would stand in the wrong place until they are fitted.
    if (wearer !== this.#wearer) own.others.value = [];
    this.#wearer = wearer;
    if (shown?.step.type !== 'dress' || !shown.settled) return;
    const { recipe, step } = shown;
    this.#work.start((signal) => this.#follow(recipe, step, signal));
  }

  async #follow(recipe: Recipe, step: DressStep, signal: AbortSignal): Promise<void> {
    const { runner } = this.parts;
    const source = await runner.opened(recipe, step.from, { signal });
    if (signal.aborted) return;
    this.own.source.value = source;
    const worn: Worn[] = [];
    for (const other of recipe.steps) {
      if (other.type !== 'dress' || other.id === step.id || other.to !== step.to) continue;
      const found = await this.#worn(recipe, other, signal);
      if (found) worn.push(found);
    }
    if (!signal.aborted) this.own.others.value = worn;
  }

  /** Another garment; one that cannot be fitted says why once it is opened. */
  async #worn(recipe: Recipe, { id, garment }: DressStep, signal: AbortSignal): Promise<Worn | null> {
    const { runner } = this.parts;
    try {
      const { opened } = await runner.opened(recipe, garment, { signal });
      const results = await runner.run(recipe, { until: id, signal });
      return { id, positions: results.get(id)!.model.positions, triangles: opened.triangles };
    } catch (error) {
      if (isCancelled(error)) throw error;
      return null;
    }
  }
}

function figuresOf({ report }: Evaluation): DressFigures | null {
  if (report?.type !== 'dress') return null;
  const { inside, insideCentres, insideBefore, seconds } = report as ReportOf<'dress'>;
  const { prepare = 0, dress = 0 } = seconds as Readonly<Record<string, number>>;
  return {
    before: insideBefore.vertices + insideBefore.faceCentres,
    after: inside + insideCentres,
    prepare: 1000 * prepare,
    dress: 1000 * dress,
  };
}
