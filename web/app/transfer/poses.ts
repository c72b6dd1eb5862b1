// Which poses a model can be given, and what a recipe knows of counterparts by the names of handles.

import { isEmpty, toIndices, type VertexSet } from '../../core/vertex-set';
import { replaceStep, stepOf } from '../../recipe/edit';
import type { DeformStep, Recipe, Step, TransferStep } from '../../recipe/recipe';
import { mainInput, producerOf, referencesOf } from '../../recipe/references';
import { memberOf } from '../../recipe/steps/transfer';
import { setCounterpart } from '../../tools/transfer/edits';

/** The step with a pose whose handles are paired; `undefined` where `like` names something else by now, or nothing is paired (`through`). */
export const poseOf = (
  recipe: Recipe,
  { like, through }: Pick<TransferStep, 'like' | 'through'>,
): DeformStep | undefined => (through === undefined ? stepOf(recipe, like, 'deform') : undefined);

/** Ids of the steps that one depends on, its own among them. */
function closure(recipe: Recipe, step: Step): ReadonlySet<string> {
  const found = new Set([step.id]);
  for (const { name } of referencesOf(step)) {
    const maker = producerOf(recipe, name) ?? recipe.steps.find(({ id }) => id === name);
    if (maker) for (const id of closure(recipe, maker)) found.add(id);
  }
  return found;
}

/**
 * Deform steps with handles that do not start from the transfer itself; where it goes through a match, those of the match's models.
 * @param transfer  if there is one
 */
export const posesFor = (recipe: Recipe, transfer?: TransferStep): DeformStep[] =>
  recipe.steps.filter(
    (step): step is DeformStep =>
      step.type === 'deform' &&
      step.handles.length > 0 &&
      !(transfer && (closure(recipe, step).has(transfer.id) || !isWithin(recipe, transfer, step))),
  );

function isWithin(recipe: Recipe, { through }: TransferStep, pose: DeformStep): boolean {
  if (through === undefined) return true;
  const models = stepOf(recipe, through, 'match')?.models;
  return models?.includes(memberOf(through, mainInput(pose))) ?? false;
}

/** The pose to begin with: the open step's, else the last one. */
export function firstPose(recipe: Recipe, open: string): DeformStep | undefined {
  const poses = posesFor(recipe);
  return poses.find(({ id }) => id === open) ?? poses.at(-1);
}

/** The recipe in which a transfer gives another pose, moved before it if need be; its counterparts go along by name. */
export function withPose(recipe: Recipe, step: TransferStep, pose: DeformStep): Recipe {
  const handles = matched(recipe, step, pose);
  const next = replaceStep(recipe, { ...step, like: pose.id, handles });
  const needed = closure(recipe, pose);
  const at = recipe.steps.findIndex(({ id }) => id === step.id);
  const late = next.steps.slice(at).filter(({ id }) => needed.has(id));
  if (late.length === 0) return next;
  const rest = next.steps.slice(at).filter(({ id }) => !needed.has(id));
  return { ...next, steps: [...next.steps.slice(0, at), ...late, ...rest] };
}

/** For each handle of the pose that the step is to give, the counterpart that the step has for it already. */
function matched(recipe: Recipe, step: TransferStep, pose: DeformStep): TransferStep['handles'] {
  if (step.through !== undefined) return [];
  const old = poseOf(recipe, step)?.handles ?? [];
  const inOrder = step.handles.length === pose.handles.length;
  return pose.handles.map((handle, i) => {
    const name = nameKey(handle.name);
    const same = old.findIndex((each) => each.vertices === handle.vertices);
    const named = name === '' ? -1 : old.findIndex((each) => nameKey(each.name) === name);
    const found = same >= 0 ? same : named >= 0 ? named : inOrder ? i : -1;
    return step.handles[found] ?? [];
  });
}

/**
 * The step with counterparts for its open handles as the recipe knows them: those of another transfer to the same model,
 * or handles of a deform step on it, by their names; where no name is known, of as many in the same order.
 * @param count  vertices of the model
 * @returns the very same step where nothing is known
 */
export function pairedByName(recipe: Recipe, step: TransferStep, count: number): TransferStep {
  const pose = poseOf(recipe, step);
  if (!pose) return step;
  const known = knownParts(recipe, step);
  const names = new Map(known.flatMap((parts) => [...parts].reverse()).map(({ name, set }) => [name, set]));
  names.delete('');
  const open = pose.handles.map((_, i) => i).filter((i) => isEmpty(step.handles[i] ?? []));
  const byName = open.flatMap((i): Found[] => {
    const set = names.get(nameKey(pose.handles[i]!.name));
    return set ? [[i, set]] : [];
  });
  const inOrder = known.find((parts) => parts.length === pose.handles.length) ?? [];
  const found =
    byName.length > 0 ? byName : open.flatMap((i): Found[] => (inOrder[i] ? [[i, inOrder[i].set]] : []));
  return found.reduce((held, [i, set]) => {
    // What is paired by hand stays; a part that another handle has already is not taken from it.
    const taken = held.handles.flatMap((other, k) => (k === i ? [] : [...toIndices(other, count)]));
    const free = new Set(toIndices(set, count));
    for (const vertex of taken) free.delete(vertex);
    return free.size > 0 ? setCounterpart(held, i, Uint32Array.from(free), count) : held;
  }, step);
}

type Found = readonly [handle: number, set: VertexSet];

interface NamedPart {
  readonly name: string;
  readonly set: VertexSet;
}

/** Parts of the step's model that other steps have named, a list for each of those. */
const knownParts = (recipe: Recipe, { id, model }: TransferStep): NamedPart[][] =>
  recipe.steps
    .filter((other) => other.id !== id && mainInput(other) === model)
    .flatMap((other): NamedPart[][] => {
      if (other.type === 'deform')
        return [other.handles.map(({ name, vertices }) => ({ name: nameKey(name), set: vertices }))];
      if (other.type !== 'transfer') return [];
      const handles = poseOf(recipe, other)?.handles ?? [];
      return [handles.map(({ name }, i) => ({ name: nameKey(name), set: other.handles[i] ?? [] }))];
    });

const nameKey = (name: string | undefined): string => (name ?? '').trim().toLowerCase();
