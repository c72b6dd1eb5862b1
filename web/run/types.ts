import { LissomError } from '../core/errors';
import type { Model } from '../core/model';
import type { OpenedModel } from '../kernel/contract/model';
import type { ModelRef } from '../recipe/recipe';

/** Where models come from: the gallery, dropped files, a folder beside the recipe. */
export interface ModelSource {
  /**
   * The same object as long as the file is the same: its content is hashed once per object.
   *
   * @throws LissomError `model-not-found`, or what the reader says of the file
   */
  load(name: string, ref: ModelRef): Promise<Model>;
}

/** A model in the pipeline: as given or as a step left it, with what the kernel found in it. */
export interface ModelResult {
  readonly model: Model;
  readonly opened: OpenedModel;
  /** Hash of the content: equal keys, equal bytes. */
  readonly key: string;
}

/** An error with the place it happened at, for those who do not see which step or model is meant. */
export class PlacedError extends LissomError {
  constructor(
    /** `steps[0] ("bend")`, `models.body (bar.ply)` */
    readonly place: string,
    cause: LissomError,
  ) {
    super(cause.code, cause.message, cause.fault);
  }
}

/** Runs work that belongs to a place; what already has one keeps it. */
export async function placed<T>(place: string, work: () => Promise<T>): Promise<T> {
  try {
    return await work();
  } catch (error) {
    if (!(error instanceof LissomError) || error instanceof PlacedError || error.fault === 'cancelled')
      throw error;
    throw new PlacedError(place, error);
  }
}
