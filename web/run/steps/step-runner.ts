import type { Finding } from '../../core/errors';
import type { Model } from '../../core/model';
import type { Strands } from '../../core/strands';
import type { Look } from '../../kernel/contract';
import type { Step } from '../../recipe/recipe';
import type { Capacities, KernelSession } from '../session';
import type { ModelResult } from '../types';

/** What an earlier step left an input from: itself, and the models that it started from. */
export interface Origin {
  readonly step: Step;
  /** They may have been let go since: who asks the kernel about one opens it again. */
  readonly inputs: readonly Pick<ModelResult, 'model' | 'key'>[];
  /** All that it left, by name, where it leaves several models. */
  readonly models?: Readonly<Record<string, Model>> | undefined;
}

/** Something large that is about to be set up. */
export interface Preparation {
  /** Of the model that it is for. */
  readonly vertices: number;
  /** The most memory that it takes at one time, beside the model; an estimate. */
  readonly bytes: number;
}

/** What a step is run with. */
export interface StepContext {
  /** The models it names, in the order of its references (`model`; `source`, `target`). */
  readonly inputs: readonly ModelResult[];
  /** Of each of them; `undefined` for a model of the recipe. */
  readonly origins: readonly (Origin | undefined)[];
  readonly kernel: KernelSession;
  /** False: a quick preview will do. */
  readonly settle: boolean;
  readonly signal: AbortSignal | undefined;
  /** In [0, 1]. */
  readonly onProgress: (fraction: number) => void;
  /** Sees the models grow where something takes long; not asked for where nobody looks. */
  readonly onLook: ((look: Look) => void) | undefined;
  /** Hears of what takes much memory before it starts. */
  readonly onPreparation: (preparation: Preparation) => void;
}

/** The way out of a step's work, as calls of the kernel take it. */
export const signalOf = ({ signal }: Pick<StepContext, 'signal'>) => (signal ? { signal } : {});

/** What a step leaves, and its own figures for the report. */
export interface StepOutcome<Figures extends object = object> {
  /** The model in the place of its main input. */
  readonly model: Model;
  /** By the names that the table has for its outputs, where it leaves several; `model` is one of them. */
  readonly models?: Readonly<Record<string, Model>>;
  readonly strands?: Strands;
  readonly figures: Figures;
  readonly seconds: Readonly<Record<string, number>>;
  readonly peakBytes: number;
  readonly warnings: readonly Finding[];
}

/** One step type on this floor. */
export interface StepRunner<S extends Step> {
  /**
   * Checks vertex indices before anything runs.
   *
   * @param inputs  as in `StepContext`, the ones whose vertices are known so far
   * @throws LissomError `index-out-of-range`
   */
  check(step: S, path: string, inputs: readonly (InputShape | undefined)[]): void;

  /** Vertices of what it leaves, of each where it leaves several, where they are known without running it. */
  vertexCount(inputs: readonly (InputShape | undefined)[]): number | undefined;

  /**
   * All of the step that its result depends on, beside its inputs: part of the key it is cached by.
   *
   * @param makers  the steps that left its inputs, of which the inputs do not tell all
   */
  content(step: S, makers: readonly (Step | undefined)[]): unknown;

  run(step: S, context: StepContext): Promise<StepOutcome>;

  /** Puts on what costs nothing, so that what is cached need not know of it: `content` leaves it out. */
  finish?(step: S, outcome: StepOutcome): StepOutcome;

  /** What may be asked of a step beside its result, by name (`Runner.ask`). Its inputs are opened by then. */
  readonly questions?: Readonly<
    Record<string, (step: S, context: StepContext, args: never) => Promise<unknown>>
  >;

  /** How many of the things that the kernel holds for such steps are kept. */
  readonly keeps?: Capacities;
}

export interface InputShape {
  readonly name: string;
  readonly vertices: number;
  /** The step that leaves it; `undefined` for a model of the recipe. */
  readonly maker?: Step | undefined;
}
