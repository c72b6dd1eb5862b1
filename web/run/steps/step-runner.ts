import type { Finding } from '../../core/errors';
import type { Model } from '../../core/model';
import type { Strands } from '../../core/strands';
import type { Step } from '../../recipe/recipe';
import type { KernelSession } from '../session';
import type { ModelResult } from '../types';

/** What a step is run with. */
export interface StepContext {
  /** The models it names, in the order of its references (`model`; `source`, `target`). */
  readonly inputs: readonly ModelResult[];
  readonly kernel: KernelSession;
  /** False: a quick preview will do. */
  readonly settle: boolean;
  readonly signal: AbortSignal | undefined;
  /** In [0, 1]. */
  readonly onProgress: (fraction: number) => void;
}

/** What a step leaves: a model, and its own figures for the report. */
export interface StepOutcome {
  readonly model: Model;
  readonly strands?: Strands;
  readonly figures: Readonly<Record<string, unknown>>;
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

  /** Vertices of the result where they are known without running it. */
  vertexCount(inputs: readonly (InputShape | undefined)[]): number | undefined;

  /** All of the step that its result depends on, beside its inputs: part of the key it is cached by. */
  content(step: S): unknown;

  run(step: S, context: StepContext): Promise<StepOutcome>;
}

export interface InputShape {
  readonly name: string;
  readonly vertices: number;
}
