// Built-in models: a file of the gallery as it is, or what is made of one.

import { type Scaling, scaled } from '../core/scaled/scaled';
import { readModel } from './formats';
import type { ReadResult } from './reading';

/** What the gallery's index says of a model. */
export interface BuiltIn {
  readonly name: string;
  /** In the gallery's folder. */
  readonly file: string;
  /** Present for a model that no file holds: what is made of `file` when it is first asked for. */
  readonly made?: Scaling;
}

/**
 * In slices: yields how far it is, in [0, 1], and returns the model under its built-in name.
 *
 * @param bytes  of `file`
 * @throws LissomError  what the file's reader says
 */
export function* builtInModel(
  { name, file, made }: BuiltIn,
  bytes: Uint8Array,
): Generator<number, ReadResult> {
  const { model, notes } = readModel(bytes, file);
  return { model: { ...(made ? yield* scaled(model, made) : model), name }, notes };
}

/** The model, whatever it takes. @throws as `builtInModel` */
export function builtInAtOnce(entry: BuiltIn, bytes: Uint8Array): ReadResult {
  const making = builtInModel(entry, bytes);
  for (;;) {
    const { done, value } = making.next();
    if (done) return value;
  }
}
