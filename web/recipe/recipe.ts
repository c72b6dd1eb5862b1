// The document: the models that go in and the steps done to them. One validated schema per step type;
// everything else about a recipe (link, file, undo, command line) is derived from these.

import * as v from 'valibot';
import { MAX_STEPS } from './limits';
import { fileName, listUpTo, oneOf, stepId } from './schema-parts';
import { deformStep } from './steps/deform';
import { hairStep } from './steps/hair';
import { mergeStep } from './steps/merge';

/** The version that is written. `migrations` knows how to read the earlier ones. */
export const RECIPE_VERSION = 1;

const MESH_EXTENSIONS: readonly string[] = ['obj', 'ply', 'stl', 'glb', 'gltf'];
const STRAND_EXTENSIONS: readonly string[] = ['abc', 'usda', 'hair', 'glb', 'obj', 'ply'];

/** Formats that a step's output can be written in, by its file's extension. */
export const outputExtensions = (type: Step['type']): readonly string[] =>
  type === 'hair' ? STRAND_EXTENSIONS : MESH_EXTENSIONS;

/** Names of models: short, printable, usable as a file stem. */
const name = v.pipe(
  v.string(),
  v.regex(/^[\p{L}\p{N}][\p{L}\p{N} ._-]{0,63}$/u, 'a name of 1 to 64 letters, digits, spaces, . _ or -'),
);

const modelRef = v.union(
  [
    v.strictObject({ file: fileName }),
    v.strictObject({ builtin: v.pipe(v.string(), v.regex(/^[a-z0-9]+(-[a-z0-9]+)*$/, 'a kebab-case name')) }),
  ],
  oneOf(['file', 'builtin'], '{ "file": "name.ply" } or { "builtin": "name" }'),
);

const output = v.strictObject({
  step: stepId,
  file: v.pipe(
    fileName,
    v.regex(/^[^/\\\p{Cc}]+$/u, 'a file name without folders'),
    v.maxBytes(255, 'a file name of at most 255 bytes'),
  ),
});

/** One line per step type: the registry of this floor. */
export const stepSchema = v.variant('type', [deformStep, mergeStep, hairStep]);

export const recipeSchema = v.strictObject({
  lissom: v.literal(RECIPE_VERSION),
  models: v.record(name, modelRef),
  steps: listUpTo(MAX_STEPS, stepSchema),
  outputs: v.optional(listUpTo(MAX_STEPS, output), []),
});

export type Recipe = v.InferOutput<typeof recipeSchema>;
export type Step = v.InferOutput<typeof stepSchema>;
export type StepType = Step['type'];
export type ModelRef = v.InferOutput<typeof modelRef>;
export type { DeformHandle, DeformStep } from './steps/deform';
export type { HairStep } from './steps/hair';
export type { MergeStep } from './steps/merge';
