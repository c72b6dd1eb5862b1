// What is computed of the open step for the screen, and how a wing says to compute it.

import type { ReadonlySignal } from '@preact/signals';
import type { LissomError } from '../core/errors';
import type { Strands } from '../core/strands';
import type { Recipe, Step } from '../recipe/recipe';
import type { Runner } from '../run/evaluate';
import type { StepReport } from '../run/results';
import type { ModelResult } from '../run/types';
import type { MotionTable, SurfaceMotion } from '../view/motion/types';
import type { MessageKey } from './i18n';

export type RunnerPort = Pick<Runner, 'run' | 'opened' | 'ask'>;

export interface EvaluatorPort {
  readonly result: ReadonlySignal<Evaluation | null>;
  /** Resolves once nothing runs or waits. */
  settled(): Promise<void>;
}

/** A model moved on the graphics card. */
export interface Moved {
  /** Stays the same object from one move to the next. */
  readonly motion: SurfaceMotion;
  /** See `MotionPort.move`. */
  readonly table: MotionTable;
}

/** The open step's result. */
export interface Evaluation {
  readonly recipe: Recipe;
  readonly step: Step;
  /** The models that came in, in the order of the step's references. */
  readonly inputs: readonly ModelResult[];
  /** The model on screen: what the step leaves where it makes a new surface, else the one it changes. */
  readonly shown: ModelResult;
  /** Where the vertices of the model on screen are. */
  readonly positions: Float64Array;
  /** Who wears what is shown: it stands on screen in its place, and what is shown is laid over it. */
  readonly wearer: ModelResult | null;
  /** How the graphics card moves the model on screen meanwhile; `null`: it is where `positions` say. */
  readonly moved: Moved | null;
  /** Of a step that grows some. */
  readonly strands: Strands | null;
  /** `null` for a step that does nothing yet. */
  readonly report: StepReport | null;
  /** Why the step could not be run as it is asked for, where its inputs are shown instead. */
  readonly problem: LissomError | null;
  /** False while a gesture is under way, and while only the first of the strands are there. */
  readonly settled: boolean;
  /** Milliseconds from request to result. */
  readonly elapsed: number;
}

/** What a strategy makes of a step; the rest of an evaluation is the evaluator's. */
export type Outcome = Pick<Evaluation, 'inputs' | 'shown' | 'positions'> &
  Partial<Pick<Evaluation, 'wearer' | 'moved' | 'strands' | 'report' | 'problem' | 'settled'>>;

/** A state of the open step that is to be shown. */
export interface Request<S extends Step = Step> {
  readonly recipe: Recipe;
  readonly step: S;
  /** A gesture is under way: the next request comes soon. */
  readonly live: boolean;
  /** What the strategy's `wish` said. */
  readonly wish: string;
}

export interface Evaluating {
  readonly runner: RunnerPort;
  readonly signal: AbortSignal;
  /** @param fraction  in [0, 1] */
  readonly onProgress: (fraction: number) => void;
  /** Says more of what is going on than the strategy's `busy` does. */
  readonly say: (label: string) => void;
  /** Whether there is time for the whole result; else a quick preview will do. */
  readonly settle: boolean;
  /** What is on screen. */
  readonly before: Evaluation | null;
  /** Shows something on the way, unless the request has been given up. */
  show(outcome: Outcome): void;
}

/** How a wing's steps are computed for the screen. */
export interface Strategy<S extends Step = Step> {
  /** What long work is called. */
  readonly busy: MessageKey;
  /** What of the result is asked for, beside what the recipe says; reads signals. Other wishes, other requests. */
  wish?(step: S): string;
  /**
   * Whether what may still be under way for `last` is of use for `next`, both of the same step type. A factorization
   * for handles that are no longer asked for, or all the strands of a style that has changed since, are not.
   */
  worthWaiting(last: Request<S>, next: Request<S>): boolean;
  run(request: Request<S>, evaluating: Evaluating): Promise<Outcome>;
  /** The work was stopped by hand. */
  stopped?(step: S): void;
}
