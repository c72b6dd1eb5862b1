import { effect } from '@preact/signals';
import type { State } from './state';

/** An edit, or opening something else, has the document back on screen. @returns the function that ends it */
export function endViewingOnChange(state: State): () => void {
  const of = () => [state.recipe.value, state.selection.value.step, state.opened.value];
  let before: unknown[] = [];
  return effect(() => {
    const now = of();
    if (now.some((each, i) => each !== before[i])) state.viewing.value = null;
    before = now;
  });
}
