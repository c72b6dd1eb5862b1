// The document: the models that go in and the steps done to them. One validated schema per step type;
// everything else about a recipe (link, file, undo, command line) is derived from these.

import * as v from 'valibot';
import { MAX_STEPS } from './limits';
import { fileName, listUpTo, oneOf, reference } from './schema-parts';
import { type StepRow, stepType } from './step-row';
import { blendMembers, blendStep } from './steps/blend';
import { curvesStep } from './steps/curves';
import { deformStep } from './steps/deform';
import { dressMembers, dressStep } from './steps/dress';
import { hairStep } from './steps/hair';
import { matchStep } from './steps/match';
import { mergeStep } from './steps/merge';
import { transferMembers, transferStep } from './steps/transfer';

/** The version that is written. `migrations` knows how to read the earlier ones. */
export const RECIPE_VERSION = 1;

/** One row per step type: the registry of this floor. The schema file lists them in this order. */
export const STEP_TYPES = {
  deform: stepType(deformStep, { main: 'model', writes: 'mesh', workspace: 'deform' }),
  merge: stepType(mergeStep, { main: 'target', writes: 'mesh', workspace: 'merge' }),
  hair: stepType(hairStep, { main: 'model', writes: 'strands', workspace: 'hair' }),
  transfer: stepType(transferStep, {
    main: 'model',
    writes: 'mesh',
    workspace: 'transfer',
    members: transferMembers,
  }),
  curves: stepType(curvesStep, { main: 'model', writes: 'mesh', skin: true, workspace: 'curves' }),
  match: stepType(matchStep, {
    main: 'models',
    writes: 'meshes',
    workspace: 'match',
    outputs: ({ models }) => models,
  }),
  blend: stepType(blendStep, { main: 'match', writes: 'mesh', workspace: 'blend', members: blendMembers }),
  dress: stepType(dressStep, { main: 'garment', writes: 'mesh', workspace: 'dress', members: dressMembers }),
};

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
  step: reference,
  file: v.pipe(
    fileName,
    v.regex(/^[^/\\\p{Cc}]+$/u, 'a file name without folders'),
    v.maxBytes(255, 'a file name of at most 255 bytes'),
  ),
  /** The model at rest with joints that hold the pose, instead of the posed model; what is kept to be played is played. */
  skin: v.optional(v.boolean()),
  /** With the other models that the step leaves as morph targets. */
  morphs: v.optional(v.boolean()),
});

const stepSchema = v.variant(
  'type',
  Object.values(STEP_TYPES).map(({ schema }) => schema),
);

export const recipeSchema = v.strictObject({
  lissom: v.literal(RECIPE_VERSION),
  models: v.record(name, modelRef),
  steps: listUpTo(MAX_STEPS, stepSchema),
  outputs: v.optional(listUpTo(MAX_STEPS, output), []),
});

export type Recipe = v.InferOutput<typeof recipeSchema>;
export type Step = v.InferOutput<typeof stepSchema>;
export type StepType = keyof typeof STEP_TYPES;
/** Where steps are worked on: what the table names. */
export type WorkspaceId = Exclude<(typeof STEP_TYPES)[StepType]['workspace'], null>;
export type StepOf<T extends StepType> = Extract<Step, { readonly type: T }>;
export type ModelRef = v.InferOutput<typeof modelRef>;
export type { BlendStep } from './steps/blend';
export type { CurvesStep } from './steps/curves';
export type { DeformHandle, DeformStep } from './steps/deform';
export type { DressStep } from './steps/dress';
export type { HairStep } from './steps/hair';
export type { MatchStep } from './steps/match';
export type { MergeStep } from './steps/merge';
export type { TransferStep } from './steps/transfer';

export const stepRow = (
  type: StepType,
): Omit<StepRow<Step>, 'workspace'> & { readonly workspace: WorkspaceId | null } => STEP_TYPES[type];

/** Where a step is worked on; `null`: nowhere of its own. */
export const workspaceOf = (step: Step | undefined): WorkspaceId | null =>
  step ? stepRow(step.type).workspace : null;
