// Strands of a file, looked at without becoming part of anything: the recipe stays as it is, and the next edit, or
// opening something else, has it back on screen.

import { computed, effect, type ReadonlySignal } from '@preact/signals';
import type { Model } from '../../core/model';
import type { Groom, Strands } from '../../core/strands';
import { placedOn } from '../../io/strands/place';
import { triangulate } from '../../io/triangulate';
import { scalpOf } from '../../run/steps/hair/scalp';
import type { ViewModel, ViewportPort } from '../../view/types';
import type { Evaluation, Evaluator } from '../evaluation';
import type { State } from '../state';

export interface ViewedStrands {
  readonly name: string;
  readonly strands: Strands;
  readonly head: ViewModel | null;
  /** The file brings its head, the open one fits, or neither. */
  readonly on: 'own-head' | 'open-head' | 'nothing';
}

/** @param open  what is on screen: its head is used where the file brings none and the roots lie on it */
export function viewed({ name, strands, head }: Groom, open: Evaluation | null): ViewedStrands {
  if (head) return { name, strands, head: drawable(head), on: 'own-head' };
  if (open?.step.type === 'hair') {
    const { model, opened } = open.input;
    const placed = placedOn(model, scalpOf(open.step, model), strands);
    if (placed) return { name, strands: placed, head: viewModel(model, opened), on: 'open-head' };
  }
  return { name, strands, head: null, on: 'nothing' };
}

/** Such a head is not for the kernel: it is seen, not touched. */
function drawable(head: Model): ViewModel {
  const welded = Int32Array.from({ length: head.positions.length / 3 }, (_, v) => v);
  return viewModel(head, { triangles: trianglesOf(head), welded });
}

function trianglesOf(head: Model): Uint32Array {
  const { triangles } = triangulate(head);
  return triangles.map((corner) => head.faceVertices[corner]!);
}

export function viewModel(model: Model, { triangles, welded }: Pick<ViewModel, 'triangles' | 'welded'>) {
  const { positions, faceOffsets, faceVertices, colors, upAxis } = model;
  const more = { ...(colors && { colors }), ...(upAxis && { upAxis }) };
  return { positions, triangles, faceOffsets, faceVertices, welded, ...more } satisfies ViewModel;
}

/** What the open step's own pictures are made of: nothing while a file's strands are looked at. */
export const besidesViewed = (state: State, { result }: Pick<Evaluator, 'result'>): typeof result =>
  computed(() => (state.hair.viewed.value ? null : result.value)) as ReadonlySignal<Evaluation | null>;

/** Called after everything else that draws. @returns the function that ends it */
export function syncViewed(viewport: ViewportPort, state: State): () => void {
  return effect(() => {
    const shown = state.hair.viewed.value;
    if (!shown) return;
    viewport.setModel(shown.head);
    viewport.setHairOptions({ widthScale: 1 });
    viewport.setHair(shown.strands);
    viewport.fit();
  });
}

/** @returns the function that ends it */
export function endViewingOnChange(state: State): () => void {
  const of = () => [state.recipe.value, state.selection.value.step, state.opened.value];
  let before: unknown[] = [];
  return effect(() => {
    const now = of();
    if (now.some((each, i) => each !== before[i])) state.hair.viewed.value = null;
    before = now;
  });
}
