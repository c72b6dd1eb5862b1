// Models side by side: viewports beside the main one, made when they are first needed, for browsers give a page a
// limited number of 3D canvases. The wing that is open has them; it leaves them empty.

import { type ReadonlySignal, signal } from '@preact/signals';
import type { ModelResult } from '../run/types';
import type { ViewportPort } from '../view/types';
import { viewModel } from './shown-model';

export interface Pane {
  readonly viewport: ViewportPort;
  /** What it is drawn in; placed on the page by whoever shows it. */
  readonly frame: HTMLElement;
}

export class Panes {
  readonly #panes = signal<readonly Pane[]>([]);

  /** @param make  `null` where the browser has no more canvases to give */
  constructor(private readonly make: () => Pane | null) {}

  get all(): ReadonlySignal<readonly Pane[]> {
    return this.#panes;
  }

  /** @returns so many, or none where so many cannot be had */
  take(count: number): readonly Pane[] | null {
    while (this.#panes.peek().length < count) {
      const pane = this.make();
      if (!pane) return null;
      this.#panes.value = [...this.#panes.peek(), pane];
    }
    return this.#panes.peek().slice(0, count);
  }
}

/** Shows a model that is not worked on in the main viewport; only another one takes the camera back to its start. */
export function paneModel(viewport: ViewportPort): (next: ModelResult | null) => void {
  let shown: ModelResult | null = null;
  return (next) => {
    if (next?.opened !== shown?.opened || next?.model.colors !== shown?.model.colors)
      viewport.setModel(next && viewModel(next.model, next.opened));
    shown = next;
  };
}
