// The sharp edges that the angle keeps, for who looks at the models before they are matched.

import { effect } from '@preact/signals';
import { isCancelled } from '../../core/errors';
import type { ModelResult } from '../../run/types';
import type { WingParts } from '../wing-parts';
import type { MatchState } from './state';

type Rows = readonly Uint32Array[];

/** Keeps them up to date. @returns the function that ends it */
export function followKept(own: MatchState, { document, runner }: Pick<WingParts, 'document' | 'runner'>) {
  let abort = new AbortController();
  /** Of each model, by what it is, those of the last angle. */
  const known = new Map<string, { readonly angle: number; readonly rows: Rows }>();
  const stop = effect(() => {
    const step = own.step.value;
    const models = own.models.value;
    const angle = step?.sharpAngle;
    abort.abort();
    abort = new AbortController();
    if (!step || angle === undefined || models.length !== step.models.length) {
      if (own.kept.peek().length > 0) own.kept.value = [];
      return;
    }
    // What runs has the kernel.
    if (own.running.value) return;
    const { signal } = abort;
    const { recipe } = document;
    const rowsOf = async (held: ModelResult, model: number): Promise<Rows> => {
      const before = known.get(held.key);
      if (before?.angle === angle) return before.rows;
      const rows = await runner.ask(recipe, step.id, 'sharpEdges', { model, angle }, { signal });
      known.set(held.key, { angle, rows });
      return rows;
    };
    const all = async () => {
      const kept: Rows[] = [];
      for (const [at, held] of models.entries()) kept.push(await rowsOf(held, at));
      return kept;
    };
    all()
      .then((kept) => {
        if (signal.aborted) return;
        own.kept.value = kept;
        const held = new Set(models.map(({ key }) => key));
        for (const key of known.keys()) if (!held.has(key)) known.delete(key);
      })
      .catch((error: unknown) => {
        // Edges that cannot be had are not shown.
        if (!isCancelled(error)) own.kept.value = [];
      });
  });
  return () => {
    stop();
    abort.abort();
    own.kept.value = [];
  };
}
