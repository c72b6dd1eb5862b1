// What the workspace shows beside the result follows it: the pose it is like, what it took, what it did.

import type { Recipe, TransferStep } from '../../recipe/recipe';
import { mainOf, type ReportOf } from '../../run/results';
import type { Evaluation } from '../evaluated';
import { NewestWork } from '../newest-work';
import { problemText } from '../problem-text';
import type { WingParts } from '../wing-parts';
import { poseOf } from './poses';
import type { SourcePose, TransferFigures, TransferState } from './state';

export class Follow {
  readonly #work: NewestWork;
  /** What the source on screen was made of: the pose as written, and its result. */
  #source: readonly unknown[] = [];

  constructor(
    private readonly own: TransferState,
    private readonly parts: Pick<WingParts, 'runner' | 'messages'>,
  ) {
    this.#work = new NewestWork(parts.messages);
  }

  publish(shown: Evaluation | null): void {
    const { own } = this;
    this.#work.end();
    own.positions.value = shown?.positions ?? null;
    own.figures.value = shown && figuresOf(shown);
    own.problem.value = problemText(shown, 'transfer.problem.');
    if (!shown || !own.figures.value) own.whatItDid.value = null;
    if (!shown) return;
    this.#work.start((signal) => this.#follow(shown, signal));
  }

  /** The pose that a step is to give, made where it is not known yet; `null` where that names no pose. */
  async source(
    recipe: Recipe,
    { like, through }: Pick<TransferStep, 'like' | 'through'>,
    signal?: AbortSignal,
  ): Promise<SourcePose | null> {
    const step = recipe.steps.find(({ id }) => id === like);
    const handles = poseOf(recipe, { like, through })?.handles;
    if (!step || !(handles || through !== undefined)) return null;
    const results = await this.parts.runner.run(recipe, { until: like, ...(signal && { signal }) });
    const { inputs, model } = results.get(like)!;
    return { id: like, handles: handles ?? [], rest: mainOf(step, inputs), posed: model.positions };
  }

  /** The runner knows the results by now, so this only reads and measures. */
  async #follow(
    { recipe, step, inputs, settled, report, shown }: Evaluation,
    signal: AbortSignal,
  ): Promise<void> {
    if (step.type !== 'transfer') return;
    const made = [recipe.steps.find(({ id }) => id === step.like), step.through, inputs[1]?.opened];
    if (inputs.length < 2 || made.some((each, i) => each !== this.#source[i])) {
      this.own.source.value = await this.source(recipe, step, signal);
      this.#source = made;
    }
    if (!settled || !report) return;
    const results = await this.parts.runner.run(recipe, { until: step.id, signal, measure: true });
    const { volumeRatio, edgeRms, flippedTriangles } = results.get(step.id)!.measured!;
    this.own.whatItDid.value = { volumeRatio, edgeRms, flippedTriangles, closed: shown.opened.closed };
  }
}

function figuresOf({ report }: Evaluation): TransferFigures | null {
  if (report?.type !== 'transfer') return null;
  const { unknowns, iterations, seconds } = report as ReportOf<'transfer'>;
  const { fields = 0, reduce = 0, prepare = 0, perIteration = 0, solve = 0 } = seconds;
  return {
    unknowns,
    iterations,
    prepare: 1000 * (fields + reduce + prepare),
    transfer: 1000 * (iterations * perIteration + solve),
  };
}
