import type { Finding } from '../core/errors';
import type { Model } from '../core/model';
import type { Measured, OpenedModel } from '../kernel/contract';
import type { ModelRef } from '../recipe/recipe';

/** Where models come from: the gallery, dropped files, a folder beside the recipe. */
export interface ModelSource {
  /** @throws LissomError `model-not-found`, or what the reader says of the file */
  load(name: string, ref: ModelRef): Promise<Model>;
}

/** A model in the pipeline: as given or as a step left it, with what the kernel found in it. */
export interface ModelResult {
  readonly model: Model;
  readonly opened: OpenedModel;
  /** Hash of the content: equal keys, equal bytes. */
  readonly key: string;
}

/** One step's line in the report (RECIPES); each step type adds its own figures. */
export interface StepReport {
  readonly id: string;
  readonly type: string;
  readonly vertices: number;
  readonly faces: number;
  readonly seconds: Readonly<Record<string, number>>;
  readonly peakBytes: number;
  readonly warnings: readonly Finding[];
  readonly [figure: string]: unknown;
}

export interface StepResult {
  /** The model the step leaves; for a deform step the input with other positions. */
  readonly model: Model;
  readonly input: ModelResult;
  readonly report: StepReport;
  readonly measured?: Measured;
}
