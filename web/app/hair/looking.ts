// Strands of a file, looked at without becoming part of anything: the recipe stays as it is, and the next edit, or
// opening something else, has it back on screen.

import { LissomError } from '../../core/errors';
import type { Model } from '../../core/model';
import { type Groom, type Strands, strandCount } from '../../core/strands';
import { readStrands } from '../../io/index';
import { placedOn } from '../../io/strands/place';
import { triangulate } from '../../io/triangulate';
import { scalpOf } from '../../run/steps/hair/scalp';
import { HAIR } from '../../view/hair/hair-layer';
import type { ViewModel, ViewportPort } from '../../view/types';
import type { Evaluation } from '../evaluated';
import { t } from '../i18n';
import { viewModel } from '../shown-model';
import type { Viewing } from '../state';
import type { LooseFile } from '../wing';
import type { WingParts } from '../wing-parts';

/** Strands on screen in place of the document. */
export interface ViewedStrands extends Viewing {
  readonly name: string;
  readonly strands: Strands;
  readonly head: ViewModel | null;
  /** The file brings its head, the open one fits, or neither. */
  readonly on: 'own-head' | 'open-head' | 'nothing';
}

/** @param open  what is on screen: its head is used where the file brings none and the roots lie on it */
export function viewed({ name, strands, head }: Groom, open: Evaluation | null): ViewedStrands {
  if (head) return viewing({ name, strands, head: drawable(head), on: 'own-head' });
  if (open?.step.type === 'hair') {
    const { model, opened } = open.shown;
    const placed = placedOn(model, scalpOf(open.step, model), strands);
    if (placed) return viewing({ name, strands: placed, head: viewModel(model, opened), on: 'open-head' });
  }
  return viewing({ name, strands, head: null, on: 'nothing' });
}

function viewing(shown: Omit<ViewedStrands, keyof Viewing>): ViewedStrands {
  const { name, strands, head, on } = shown;
  const points = strands.points.length / 3;
  return {
    ...shown,
    said: t(`ui.viewed.${on}`, { name, strands: strandCount(strands), points }),
    back: 'hair.end-viewing',
    status: (key) => t('status.viewed', { back: key('edit.cancel') }),
    mount: (viewport) => mountStrands(viewport, head, strands),
  };
}

function mountStrands(viewport: ViewportPort, head: ViewModel | null, strands: Strands): () => void {
  const { port, unmount } = viewport.mount(HAIR);
  viewport.setModel(head);
  port.setHairOptions({ widthScale: 1 });
  port.setHair(strands);
  viewport.fit();
  return unmount;
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

/** What becomes of a file with strands in it. */
export class Looking {
  constructor(private readonly parts: Pick<WingParts, 'state' | 'evaluator' | 'messages'>) {}

  /**
   * Shows the strands of a file, or offers to: an OBJ may be hair alone, hair with its head, or a model with a few
   * loose edges.
   *
   * @throws LissomError  where a file of strands alone cannot be read
   */
  async take({ name, bytes, model, openModel }: LooseFile): Promise<void> {
    const { state, messages } = this.parts;
    if (!model) return this.#show(readStrands(bytes, name));
    const groom = strandsIn(name, bytes, model);
    if (!groom) return openModel();
    if (!groom.head) return this.#show(groom);
    if (state.workspace.peek() === 'hair') {
      this.#show(groom);
      const run = () => this.#again(openModel);
      messages.toast('info', t('toast.lines-seen', { name }), { label: t('toast.open-model'), run });
      return;
    }
    await openModel();
    const run = () => this.#again(() => this.#show(groom));
    messages.toast('info', t('toast.lines', { name }), { label: t('toast.see-lines'), run });
  }

  #show(groom: Groom): void {
    const { state, evaluator } = this.parts;
    state.dialog.value = null;
    state.viewing.value = viewed(groom, evaluator.result.peek());
  }

  async #again(act: () => void | Promise<void>): Promise<void> {
    try {
      await act();
    } catch (error) {
      this.parts.messages.failed(error);
    }
  }
}

/** @returns `null` where the lines are no strands: a model may have lines that are of no use here */
function strandsIn(name: string, bytes: Uint8Array, model: Model): Groom | null {
  try {
    return readStrands(bytes, name, model);
  } catch (error) {
    if (error instanceof LissomError && error.fault === 'input') return null;
    throw error;
  }
}
