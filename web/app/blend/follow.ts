// What the workspace shows beside the result follows it: the skins, what measures they have, what it took.

import { hashValue } from '../../core/hash';
import type { BlendStep } from '../../recipe/recipe';
import type { ReportOf } from '../../run/results';
import { wanting } from '../../tools/blend/edits';
import type { Evaluation } from '../evaluated';
import { NewestWork } from '../newest-work';
import { problemText } from '../problem-text';
import type { WingParts } from '../wing-parts';
import type { BlendFigures, BlendState } from './state';

export class Follow {
  readonly #work: NewestWork;
  /** What the spread that is known was measured on, and how. */
  #measured = '';

  constructor(
    private readonly own: BlendState,
    private readonly parts: Pick<WingParts, 'runner' | 'messages'>,
  ) {
    this.#work = new NewestWork(parts.messages);
  }

  publish(shown: Evaluation | null): void {
    const { own } = this;
    this.#work.end();
    own.figures.value = shown && figuresOf(shown);
    own.problem.value = problemText(shown, 'blend.problem.');
    if (!shown) own.skins.value = null;
    // A drag brings nothing new.
    if (!shown || shown.moved || shown.step.type !== 'blend' || !shown.report) return;
    const { step } = shown;
    this.#work.start((signal) => this.#follow(shown, step, signal));
  }

  /** The runner knows the results by now, so this only reads and measures. */
  async #follow({ recipe, shown }: Evaluation, step: BlendStep, signal: AbortSignal): Promise<void> {
    const { runner } = this.parts;
    const { skins, spread } = this.own;
    if (skins.peek()?.skin.key !== shown.key) {
      const results = await runner.run(recipe, { until: step.match, signal });
      const { models = {} } = results.get(step.match)!;
      if (signal.aborted) return;
      skins.value = {
        names: Object.keys(models),
        positions: Object.values(models).map(({ positions }) => positions),
        skin: shown,
      };
    }
    const measures = step.measures.map((measure) => wanting(measure, undefined));
    const key = hashValue({ skin: shown.key, measures });
    if (key === this.#measured) return;
    const found =
      measures.length > 0 ? await runner.ask(recipe, step.id, 'measures', measures, { signal }) : null;
    if (signal.aborted) return;
    this.#measured = key;
    spread.value = found;
  }
}

function figuresOf({ report }: Evaluation): BlendFigures | null {
  if (report?.type !== 'blend') return null;
  const { weights, measures, seconds } = report as ReportOf<'blend'>;
  const { factor = 0, measure = 0, blend = 0 } = seconds as Readonly<Record<string, number>>;
  return {
    weights,
    reached: measures.map(({ reached }) => reached),
    prepare: 1000 * factor,
    blend: 1000 * (measure + blend),
  };
}
