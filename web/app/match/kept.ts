// The sharp edges that the angle keeps, for who looks at the models before they are matched.

import { effect } from '@preact/signals';
import { isCancelled } from '../../core/errors';
import type { ModelResult } from '../../run/types';
import { NewestWork } from '../newest-work';
import type { WingParts } from '../wing-parts';
import type { MatchState } from './state';

type Rows = readonly Uint32Array[];

/** Keeps them up to date. @returns the function that ends it */
export function followKept(
  own: MatchState,
  { document, runner, messages }: Pick<WingParts, 'document' | 'runner' | 'messages'>,
) {
  const work = new NewestWork(messages);
  /** Of each model, by what it is, those of the last angle. */
  const known = new Map<string, { readonly angle: number; readonly rows: Rows }>();
  const stop = effect(() => {
    const step = own.step.value;
    const models = own.models.value;
    const angle = step?.sharpAngle;
    work.end();
    if (!step || angle === undefined || models.length !== step.models.length) {
      if (own.kept.peek().length > 0) own.kept.value = [];
      return;
    }
    // What runs has the kernel.
    if (own.running.value) return;
    const { recipe } = document;
    const rowsOf = async (held: ModelResult, model: number, signal: AbortSignal): Promise<Rows> => {
      const before = known.get(held.key);
      if (before?.angle === angle) return before.rows;
      const rows = await runner.ask(recipe, step.id, 'sharpEdges', { model, angle }, { signal });
      known.set(held.key, { angle, rows });
      return rows;
    };
    work.start(async (signal) => {
      const kept: Rows[] = [];
      try {
        for (const [at, held] of models.entries()) kept.push(await rowsOf(held, at, signal));
      } catch (error) {
        // Edges that cannot be had are not shown.
        if (!isCancelled(error)) own.kept.value = [];
        return;
      }
      if (signal.aborted) return;
      own.kept.value = kept;
      const held = new Set(models.map(({ key }) => key));
      for (const key of known.keys()) if (!held.has(key)) known.delete(key);
    });
  });
  return () => {
    stop();
    work.end();
    own.kept.value = [];
  };
}
