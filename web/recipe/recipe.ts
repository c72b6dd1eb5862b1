// The document: the models that go in and the steps done to them. One validated schema per step type;
// everything else about a recipe (link, file, undo, command line) is derived from these.

import * as v from 'valibot';
import { deformStep } from './steps/deform';

/** Names of models and steps: short, printable, usable as a file stem. */
const name = v.pipe(
  v.string(),
  v.regex(/^[\p{L}\p{N}][\p{L}\p{N} ._-]{0,63}$/u, 'a name of 1 to 64 letters, digits, spaces, . _ or -'),
);

const modelRef = v.union([
  v.strictObject({ file: v.pipe(v.string(), v.minLength(1), v.maxLength(255)) }),
  v.strictObject({ builtin: v.pipe(v.string(), v.regex(/^[a-z0-9]+(-[a-z0-9]+)*$/, 'a kebab-case name')) }),
]);

const output = v.strictObject({ step: name, file: v.pipe(v.string(), v.minLength(1), v.maxLength(255)) });

/** One line per step type: the registry of this floor. */
export const stepSchema = v.variant('type', [deformStep]);

export const recipeSchema = v.strictObject({
  lissom: v.literal(1),
  models: v.record(name, modelRef),
  steps: v.array(stepSchema),
  outputs: v.optional(v.array(output), []),
});

export type Recipe = v.InferOutput<typeof recipeSchema>;
export type Step = v.InferOutput<typeof stepSchema>;
export type ModelRef = v.InferOutput<typeof modelRef>;
export type { DeformHandle, DeformStep } from './steps/deform';
