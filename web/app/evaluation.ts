// From a recipe to what is seen: whenever the shown recipe changes, the open step is computed anew, as its wing's
// strategy says. One run at a time; of those waiting only the newest. A drag never waits for a run that a later move
// has overtaken.

import { effect, type ReadonlySignal, signal } from '@preact/signals';
import { isCancelled } from '../core/errors';
import { Latest } from '../core/latest';
import type { Step } from '../recipe/recipe';
import { busySign } from './busy-sign';
import type { Evaluation, EvaluatorPort, Outcome, Request, RunnerPort, Strategy } from './evaluated';
import { solveTime } from './figures';
import { t } from './i18n';
import type { State } from './state';

/** A live step slower than this shows a quick preview and settles on release. */
const FRAME_BUDGET = 120;

interface Parts {
  readonly runner: RunnerPort;
  readonly state: Pick<State, 'shown' | 'step' | 'previewing' | 'busy'>;
  /** Reads signals. @returns `null` until the wing that knows it is loaded */
  readonly strategyOf: (step: Step) => Strategy | null;
  /** Resolves once that wing is there. */
  readonly ready: () => Promise<unknown>;
  readonly failed: (error: unknown) => void;
}

interface Pending extends Request {
  readonly strategy: Strategy;
}

export class Evaluator implements EvaluatorPort {
  readonly #result = signal<Evaluation | null>(null);
  readonly #stop: () => void;
  readonly #runs: Latest<Pending, Evaluation>;
  /** What was asked last and has not failed. */
  #last: Pending | null = null;
  /** How long a settled solve of the open step takes, in milliseconds. */
  #settledTime = 0;

  constructor(private readonly parts: Parts) {
    const { state, failed } = parts;
    this.#runs = new Latest({
      work: (request, aborted) => this.#evaluate(request, aborted),
      deliver: (evaluation) => {
        this.#result.value = evaluation;
      },
      fail: (error) => {
        this.#last = null;
        if (!isCancelled(error)) failed(error);
      },
    });
    this.#stop = effect(() => {
      const { recipe } = state.shown.value;
      const live = state.previewing.value;
      const step = state.step.value;
      const strategy = step ? parts.strategyOf(step) : null;
      if (step && strategy) this.#push({ recipe, step, live, wish: strategy.wish?.(step) ?? '', strategy });
      else if (!step) this.#clear();
    });
  }

  get result(): ReadonlySignal<Evaluation | null> {
    return this.#result;
  }

  async settled(): Promise<void> {
    await this.parts.ready();
    await this.#runs.settled();
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

  #push(request: Pending): void {
    const last = this.#last;
    // Where only the selection changed, nothing is to be computed.
    if (last && sameRequest(last, request)) return;
    if (last && !isWorthWaiting(last, request)) this.#runs.cancel();
    this.#last = request;
    this.#runs.push(request);
  }

  /** By hand. */
  #stopped(): void {
    const last = this.#last;
    this.#last = null;
    this.#runs.cancel();
    if (last) last.strategy.stopped?.(last.step);
  }

  async #evaluate(request: Pending, aborted: AbortSignal): Promise<Evaluation> {
    const { recipe, step, live, strategy } = request;
    const started = performance.now();
    const busy = busySign(this.parts.state.busy, t(strategy.busy), () => this.#stopped());
    const evaluation = (outcome: Outcome): Evaluation => ({
      wearer: null,
      moved: null,
      strands: null,
      report: null,
      problem: null,
      settled: !live,
      ...outcome,
      recipe,
      step,
      elapsed: performance.now() - started,
    });
    try {
      const outcome = await strategy.run(request, {
        runner: this.parts.runner,
        signal: aborted,
        onProgress: busy.progress,
        say: busy.say,
        settle: !live || this.#settledTime <= FRAME_BUDGET,
        before: this.#result.peek(),
        show: (part) => {
          if (!aborted.aborted) this.#result.value = evaluation({ settled: false, ...part });
        },
      });
      if (!live) this.#settledTime = solveTime(outcome.report ?? null);
      return evaluation(outcome);
    } finally {
      busy.end();
    }
  }
}

const isWorthWaiting = (last: Pending, next: Pending): boolean =>
  last.step.type === next.step.type && next.strategy.worthWaiting(last, next);

const sameRequest = (a: Pending, b: Pending): boolean =>
  a.recipe === b.recipe && a.step === b.step && a.live === b.live && a.wish === b.wish;
