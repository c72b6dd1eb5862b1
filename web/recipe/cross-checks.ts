// What a schema cannot say: names that must be unique, references that must lead somewhere.

import { pathText, recipeError } from './problem';
import { type Recipe, type Step, type StepType, stepRow } from './recipe';
import { mainInput, namesOf, producedNames, producerOf, referencesOf } from './references';

const MESH_EXTENSIONS: readonly string[] = ['obj', 'ply', 'stl', 'glb', 'gltf'];
/** Those that can hold a skin, and morph targets. */
const SKIN_EXTENSIONS: readonly string[] = ['glb', 'gltf'];
const STRAND_EXTENSIONS: readonly string[] = ['abc', 'usda', 'hair', 'glb', 'obj', 'ply'];

/** Formats that a step's output can be written in, by its file's extension. */
export const outputExtensions = (type: StepType): readonly string[] =>
  stepRow(type).writes === 'strands' ? STRAND_EXTENSIONS : MESH_EXTENSIONS;

/** @throws LissomError `recipe-invalid` */
export function crossCheck(recipe: Recipe): void {
  const known = new Set(Object.keys(recipe.models));
  const made = new Set<string>();
  /** Steps so far that leave several models. */
  const sets = new Set<string>();
  const taken = new Set(known);
  for (const [at, step] of recipe.steps.entries()) {
    for (const { path, name, several } of referencesOf(step))
      if (!(several ? sets : known).has(name))
        throw recipeError(
          pathText(['steps', at, ...path]),
          several ? noSet(name, recipe, at, sets) : lost(name, recipe, at, known),
        );
    checkMembers(recipe, step, at);
    const double = [...namesOf(step)].find((name) => taken.has(name));
    if (double !== undefined) {
      const what = Object.hasOwn(recipe.models, double) ? 'a model' : 'an earlier step';
      throw recipeError(
        pathText(['steps', at, 'id']),
        `${quoted(double)} is the name of ${what} too; choose another id.`,
      );
    }
    for (const name of namesOf(step)) taken.add(name);
    if (stepRow(step.type).writes === 'meshes') sets.add(step.id);
    for (const name of producedNames(step)) {
      known.add(name);
      made.add(name);
    }
  }
  checkOutputs(recipe, made);
}

/** Single models of a set are named as the step that leaves it calls them. */
function checkMembers(recipe: Recipe, step: Step, at: number): void {
  const set = referencesOf(step).find(({ several }) => several);
  const maker = set && recipe.steps.find(({ id }) => id === set.name);
  const names = maker && stepRow(maker.type).outputs?.(maker);
  const changedBy = (id: string) => {
    const earlier = recipe.steps.find((each) => each.id === id);
    return earlier && mainInput(earlier);
  };
  for (const { path, name } of (names && stepRow(step.type).members?.(step, changedBy)) || [])
    if (!names?.includes(name))
      throw recipeError(
        pathText(['steps', at, ...path]),
        `${quoted(set!.name)} has no model ${quoted(name)}; it has ${listed(names!)}.`,
      );
}

function checkOutputs(recipe: Recipe, made: ReadonlySet<string>): void {
  const files = new Set<string>();
  for (const [at, { step: name, file, skin, morphs }] of recipe.outputs.entries()) {
    const wrong = (field: string, message: string) => recipeError(pathText(['outputs', at, field]), message);
    const step = producerOf(recipe, name);
    if (!step)
      throw wrong(
        'step',
        several(name, recipe) ?? `there is no step ${quoted(name)}; the steps are ${listed(made)}.`,
      );
    const known = outputExtensions(step.type);
    if (!known.includes(extensionOf(file)))
      throw wrong(
        'file',
        `cannot write ${quoted(file)}; end its name in ${known.map((extension) => `.${extension}`).join(', ')}.`,
      );
    if (skin && !stepRow(step.type).skin)
      throw wrong('skin', `a ${step.type} step has no joints; leave it out.`);
    if (skin && !SKIN_EXTENSIONS.includes(extensionOf(file)))
      throw wrong('skin', `${quoted(file)} cannot hold a skin; end its name in .glb or .gltf.`);
    if (morphs && stepRow(step.type).writes !== 'meshes')
      throw wrong(
        'morphs',
        `a ${step.type} step leaves one model, so there is nothing to morph to; leave it out.`,
      );
    if (morphs && !SKIN_EXTENSIONS.includes(extensionOf(file)))
      throw wrong('morphs', `${quoted(file)} cannot hold morph targets; end its name in .glb or .gltf.`);
    if (files.has(file)) throw wrong('file', `${quoted(file)} is written twice; choose another name.`);
    files.add(file);
  }
}

/** In lower case and without the dot; empty where there is none. */
export const extensionOf = (file: string): string => /\.([^./\\]+)$/.exec(file)?.[1]?.toLowerCase() ?? '';

function lost(name: string, recipe: Recipe, at: number, known: ReadonlySet<string>): string {
  const later = recipe.steps.findIndex((step) => namesOf(step).has(name));
  if (later === at) return `${quoted(name)} is the step itself; name a model or an earlier step.`;
  if (later > at) return `${quoted(name)} is a later step (steps[${later}]); move it before this one.`;
  return (
    several(name, recipe) ?? `there is no model or earlier step ${quoted(name)}; there are ${listed(known)}.`
  );
}

function noSet(name: string, recipe: Recipe, at: number, sets: ReadonlySet<string>): string {
  const { steps, models } = recipe;
  const found = steps.findIndex((step) => namesOf(step).has(name));
  if (found >= at) return lost(name, recipe, at, sets);
  const what = found >= 0 ? 'leaves one model' : Object.hasOwn(models, name) ? 'is a model' : 'is not there';
  return `${quoted(name)} ${what}; name an earlier step that leaves several: ${listed(sets)}.`;
}

/** What to say where a step is named that leaves several models. */
function several(name: string, { steps }: Recipe): string | undefined {
  const step = steps.find(({ id }) => id === name);
  return step && `${quoted(name)} leaves several models; name one of ${listed(producedNames(step))}.`;
}

const quoted = (text: string): string => JSON.stringify(text);
const listed = (names: Iterable<string>): string => [...names].map(quoted).join(', ') || 'none';
