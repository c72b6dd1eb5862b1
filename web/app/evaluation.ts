// From a recipe to what is seen: whenever the shown recipe changes, the open step is computed anew. One run
// at a time; of those waiting only the newest. A drag never waits for a run that a later move has overtaken.

import { effect, type ReadonlySignal, signal } from '@preact/signals';
import { isCancelled } from '../core/errors';
import { Latest } from '../core/latest';
import type { Strands } from '../core/strands';
import { stepById } from '../recipe/edit';
import type { HairStep, Recipe, Step } from '../recipe/recipe';
import type { Runner, RunOptions } from '../run/evaluate';
import { mainOf, type StepReport } from '../run/results';
import type { ModelResult } from '../run/types';
import { growsAlike, runHair, sameHead } from './hair/evaluation';
import { t } from './i18n';
import { mergeWanted, runMerge } from './merge/evaluation';
import { sameCut } from './merge/steps';
import type { State } from './state';

export type RunnerPort = Pick<Runner, 'run' | 'opened'>;

/** The open step's result: what is on screen. */
export interface Evaluation {
  readonly recipe: Recipe;
  readonly step: Step;
  readonly input: ModelResult;
  readonly positions: Float64Array;
  /** Of a hair step. */
  readonly strands: Strands | null;
  /** `null` for a step that does nothing yet: no handles, no scalp. */
  readonly report: StepReport | null;
  /** False while a gesture is under way, and for hair while only its first strands are grown. */
  readonly settled: boolean;
  /** Milliseconds from request to result. */
  readonly elapsed: number;
}

interface Request {
  readonly recipe: Recipe;
  readonly step: Step;
  readonly live: boolean;
  /** Of a merge step: how it is wanted. */
  readonly merge: ReturnType<typeof mergeWanted> | undefined;
}

/** A live step slower than this shows the first solve only and settles on release (ALGORITHMS 1, "Live"). */
const FRAME_BUDGET = 120;
const BUSY = { deform: 'busy.preparing', hair: 'busy.growing', merge: 'busy.merging' } as const;
/** Work shorter than this shows no progress, in milliseconds. */
const PATIENCE = 250;

export class Evaluator {
  readonly #result = signal<Evaluation | null>(null);
  readonly #stop: () => void;
  readonly #runs: Latest<Request, Evaluation>;
  /** What was asked last and has not failed. */
  #last: Request | null = null;
  /** How long a settled solve of the open step takes, in milliseconds. */
  #settledTime = 0;

  constructor(
    private readonly runner: RunnerPort,
    private readonly state: State,
    private readonly failed: (error: unknown) => void,
  ) {
    this.#runs = new Latest({
      work: (request, signal) => this.#evaluate(request, signal),
      deliver: (evaluation) => {
        this.#result.value = evaluation;
      },
      fail: (error) => {
        this.#last = null;
        if (!isCancelled(error)) this.failed(error);
      },
    });
    this.#stop = effect(() => {
      const { recipe, selection } = state.shown.value;
      const live = state.previewing.value;
      const step = stepById(recipe, selection.step);
      const merge = step?.type === 'merge' ? mergeWanted(state, step) : undefined;
      if (step) this.#push({ recipe, step, live, merge });
      else this.#clear();
    });
  }

  get result(): ReadonlySignal<Evaluation | null> {
    return this.#result;
  }

  /** Resolves once nothing runs or waits. */
  settled(): Promise<void> {
    return this.#runs.settled();
  }

  dispose(): void {
    this.#stop();
    this.#clear();
  }

  #clear(): void {
    this.#last = null;
    this.#runs.cancel();
    this.#result.value = null;
  }

  #push(request: Request): void {
    const last = this.#last;
    // Where only the selection changed, nothing is to be computed.
    if (last && sameRequest(last, request)) return;
    if (last && !worthWaiting(last, request)) this.#runs.cancel();
    this.#last = request;
    this.#runs.push(request);
  }

  async #evaluate(request: Request, signal: AbortSignal): Promise<Evaluation> {
    const { recipe, step, live } = request;
    const started = performance.now();
    const busy = this.#busy(t(BUSY[step.type]));
    try {
      const options = { signal, onProgress: busy.progress };
      const finished = (outcome: Outcome, settled = !live): Evaluation => ({
        ...outcome,
        recipe,
        step,
        settled,
        elapsed: performance.now() - started,
      });
      if (step.type === 'hair') return await this.#grow(step, request, options, finished);
      const outcome = await this.#run(request, options);
      const { solve = 0, rotate = 0, reconstruct = 0 } = outcome.report?.seconds ?? {};
      if (!live) this.#settledTime = 1000 * (solve + rotate + reconstruct);
      return finished(outcome);
    } finally {
      busy.end();
    }
  }

  async #run({ recipe, step, live, merge }: Request, options: RunOptions): Promise<Outcome> {
    const { signal } = options;
    if (step.type === 'deform' && step.handles.length === 0) {
      const input = await this.runner.opened(recipe, step.model, signal ? { signal } : {});
      return { input, positions: input.model.positions, strands: null, report: null };
    }
    const settle = !live || this.#settledTime <= FRAME_BUDGET;
    if (merge && step.type === 'merge')
      return runMerge(this.runner, recipe, step, merge, this.state, { ...options, settle });
    const results = await this.runner.run(recipe, { ...options, until: step.id, settle });
    const { inputs, model, report } = results.get(step.id)!;
    return { input: mainOf(step, inputs), positions: model.positions, strands: null, report };
  }

  /** The first strands at once, all of them when the hand is still. */
  async #grow(
    step: HairStep,
    { recipe, live }: Request,
    options: RunOptions,
    finished: (outcome: Outcome, settled?: boolean) => Evaluation,
  ): Promise<Evaluation> {
    const shown = this.#result.peek();
    const alike =
      shown?.step.type === 'hair' && growsAlike(shown.step, step) && sameBefore(shown.recipe, recipe, step);
    if (alike && (live || shown.settled)) {
      if (!shown.strands) return finished(shown, shown.settled);
      const { settled: settle } = shown;
      return finished(await runHair(this.runner, recipe, step, { ...options, settle }), settle);
    }
    if (shown?.step.id !== step.id) {
      // A head takes its time to be prepared; until then it is seen bare rather than not at all.
      const input = await this.runner.opened(
        recipe,
        step.model,
        options.signal ? { signal: options.signal } : {},
      );
      const bare = { input, positions: input.model.positions, strands: null, report: null };
      if (!options.signal?.aborted) this.#result.value = finished(bare, false);
    }
    if (live || !alike) {
      const first = await runHair(this.runner, recipe, step, { ...options, settle: false });
      if (live || !first.strands) return finished(first);
      if (!options.signal?.aborted) this.#result.value = finished(first, false);
    }
    return finished(await runHair(this.runner, recipe, step, { ...options, settle: true }));
  }

  /** Shows progress once the work has taken long enough to be noticed. */
  #busy(label: string) {
    let fraction: number | null = null;
    let shown = false;
    const cancel = () => {
      const step = this.#last?.step;
      this.#last = null;
      this.#runs.cancel();
      // What was stopped by hand waits for its button.
      if (step?.type === 'merge') this.state.merge.held.value = step.id;
    };
    const show = () => {
      shown = true;
      this.state.busy.value = { label, fraction, cancel };
    };
    const timer = setTimeout(show, PATIENCE);
    return {
      progress: (done: number) => {
        fraction = done;
        if (shown) show();
      },
      end: () => {
        clearTimeout(timer);
        if (shown) this.state.busy.value = null;
      },
    };
  }
}

type Outcome = Pick<Evaluation, 'input' | 'positions' | 'strands' | 'report'>;

/**
 * Whether what may still be under way is of use for the next request: a factorization for handles that are no
 * longer asked for is not, nor are all the strands of a style that has changed since.
 */
function worthWaiting(last: Request, next: Request): boolean {
  if (last.step.type !== 'hair' || next.step.type !== 'hair') return sameSession(last, next);
  return last.live && sameHead(last.step, next.step) && sameBefore(last.recipe, next.recipe, next.step);
}

const sameRequest = (a: Request, b: Request): boolean =>
  a.recipe === b.recipe && a.step === b.step && a.live === b.live && a.merge === b.merge;

/** Whether both need the same factorization: only where the handles go differs, or which points of loops meet. */
function sameSession(a: Request, b: Request): boolean {
  const [s, r] = [a.step, b.step];
  if (s.type === 'merge' && r.type === 'merge')
    return a.merge === b.merge && sameCut(s, r) && sameBefore(a.recipe, b.recipe, s);
  return (
    s.type === 'deform' &&
    r.type === 'deform' &&
    s.id === r.id &&
    s.model === r.model &&
    s.roi === r.roi &&
    s.method === r.method &&
    s.options === r.options &&
    s.handles.length === r.handles.length &&
    s.handles.every((handle, i) => handle.vertices === r.handles[i]!.vertices) &&
    sameBefore(a.recipe, b.recipe, s)
  );
}

function sameBefore(a: Recipe, b: Recipe, step: Step): boolean {
  if (a.models !== b.models) return false;
  const before = a.steps.findIndex(({ id }) => id === step.id);
  return a.steps.slice(0, before).every((each, i) => each === b.steps[i]);
}
