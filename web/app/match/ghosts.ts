// Suggestions: while a marker is not set on every model, where its counterpart may be on the others. By the skins where
// there are some, else by the markers so far.

import { effect } from '@preact/signals';
import { isCancelled } from '../../core/errors';
import type { MatchStep } from '../../recipe/recipe';
import type { ModelResult } from '../../run/types';
import { missing } from '../../tools/match/edits';
import { nearestSpot, pointOf, type Spot } from '../../tools/match/places';
import type { Vec3 } from '../../view/types';
import type { WingParts } from '../wing-parts';
import type { Ghost, MatchState } from './state';

type Parts = Pick<WingParts, 'state' | 'document' | 'runner'>;

/** Keeps the suggestions up to date. @returns the function that ends it */
export function followGhosts(own: MatchState, parts: Parts): () => void {
  const { state, document } = parts;
  let abort = new AbortController();
  const stop = effect(() => {
    const step = own.step.value;
    const marker = own.marker.value;
    const models = own.models.value;
    const result = own.result.value;
    abort.abort();
    abort = new AbortController();
    own.ghosts.value = [];
    // A preview is no place to start from, and what runs has the kernel.
    if (!step || marker === null || state.previewing.value || state.choosing.value || own.running.value)
      return;
    const { signal } = abort;
    const { recipe } = document;
    const ask = { step, marker, models, skins: result, recipe, signal };
    suggest(ask, parts)
      .then((ghosts) => {
        if (!signal.aborted) own.ghosts.value = ghosts;
      })
      .catch((error: unknown) => {
        // A suggestion that cannot be had is none.
        if (!isCancelled(error)) own.ghosts.value = [];
      });
  });
  return () => {
    stop();
    abort.abort();
    own.ghosts.value = [];
  };
}

interface Ask {
  readonly step: MatchStep;
  readonly marker: number;
  readonly models: readonly ModelResult[];
  readonly skins: MatchState['result']['value'];
  readonly recipe: WingParts['document']['recipe'];
  readonly signal: AbortSignal;
}

async function suggest(ask: Ask, parts: Parts): Promise<Ghost[]> {
  const { step, marker, models } = ask;
  const held = step.markers[marker];
  const from = held?.findIndex((place) => place !== null) ?? -1;
  if (!held || from < 0 || models.length !== step.models.length) return [];
  const point = pointOf(models[from]!, held[from]!);
  if (!point) return [];
  const ghosts: Ghost[] = [];
  for (const model of missing(held)) {
    const spot = await counterpart(ask, parts, from, model, point);
    if (spot) ghosts.push({ marker, model, spot });
  }
  return ghosts;
}

async function counterpart(
  { step, models, skins, recipe, signal }: Ask,
  { runner }: Parts,
  from: number,
  to: number,
  point: Vec3,
): Promise<Spot | null> {
  const place = Float64Array.from(point);
  const found = skins
    ? await runner.ask(
        recipe,
        step.id,
        'carryPlaces',
        {
          from: skins.skins[from]!.positions,
          to: skins.skins[to]!.positions,
          triangles: skins.triangles,
          places: place,
        },
        { signal },
      )
    : await runner.ask(recipe, step.id, 'guessPlace', { from, to, place }, { signal });
  const [x = 0, y = 0, z = 0] = found;
  return nearestSpot(models[to]!, [x, y, z])?.spot ?? null;
}
