// What each wing has on the page, one line each: the registry of this floor. Loaded with the wing itself.

import { type ReadonlySignal, signal } from '@preact/signals';
import type { ComponentType } from 'preact';
import type { WorkspaceId } from '../recipe/recipe';

/** A wing on the page. What it leaves out is not shown. */
export interface Face {
  /** The side panel. */
  readonly Panels: ComponentType;
  /** Beside the main viewport: models in panes of their own. */
  readonly Stage?: ComponentType;
  /** What the stage is called for its layout. */
  readonly stageClass?: string;
  /** Over the viewport: what its colours mean. */
  readonly Legend?: ComponentType;
  /** The status bar's figures, instead of the usual ones. */
  readonly Figures?: ComponentType;
  /** Commands that a tool in hand offers beside itself. */
  extras(tool: string): readonly string[];
  /** Commands that join those of the view. */
  readonly viewCommands?: readonly string[];
}

const faces = {
  deform: () => import('./deform/face'),
  hair: () => import('./hair/face'),
  merge: () => import('./merge/face'),
  transfer: () => import('./transfer/face'),
  curves: () => import('./curves/face'),
  match: () => import('./match/face'),
  blend: () => import('./blend/face'),
  dress: () => import('./dress/face'),
} satisfies Readonly<Record<WorkspaceId, () => Promise<{ readonly face: Face }>>>;

const loaded = signal<Partial<Readonly<Record<WorkspaceId, Face>>>>({});
const loading = new Map<WorkspaceId, Promise<void>>();

/** Loads a wing's part of the page. @returns a promise that rejects where it could not be fetched */
export function loadFace(id: WorkspaceId): Promise<void> {
  let under = loading.get(id);
  if (!under) {
    under = faces[id]().then(({ face }) => {
      loaded.value = { ...loaded.peek(), [id]: face };
    });
    under.catch(() => loading.delete(id));
    loading.set(id, under);
  }
  return under;
}

export const loadedFaces: ReadonlySignal<Partial<Readonly<Record<WorkspaceId, Face>>>> = loaded;
