// The wings, one line each: the registry of this floor. Each is a chunk of its own, loaded when it is first needed.

import type { LooseKind } from '../io/loose';
import type { WorkspaceId } from '../recipe/recipe';
import type { WingModule } from './wing-parts';

interface Entry {
  readonly icon: string;
  /** The shortcut that opens its workspace. */
  readonly key: string;
  /** Files that it knows to look at without opening them. */
  readonly looks?: LooseKind;
  readonly load: () => Promise<WingModule>;
}

export const wings = {
  deform: { icon: 'move', key: 'Shift+1', load: () => import('./deform/wing') },
  hair: { icon: 'spline', key: 'Shift+2', looks: 'strands', load: () => import('./hair/wing') },
  merge: { icon: 'combine', key: 'Shift+3', load: () => import('./merge/wing') },
  transfer: { icon: 'person-standing', key: 'Shift+4', load: () => import('./transfer/wing') },
  curves: { icon: 'bone', key: 'Shift+5', load: () => import('./curves/wing') },
  match: { icon: 'git-compare-arrows', key: 'Shift+6', load: () => import('./match/wing') },
  blend: { icon: 'triangle', key: 'Shift+7', load: () => import('./blend/wing') },
  dress: { icon: 'shirt', key: 'Shift+8', load: () => import('./dress/wing') },
} as const satisfies Readonly<Record<WorkspaceId, Entry>>;

/** In the order of the buttons. */
export const WORKSPACES = Object.keys(wings) as WorkspaceId[];
/** Where a document opens that says nothing else. */
export const HOME: WorkspaceId = 'deform';

/** The wing that knows files of a kind. */
export const wingFor = (kind: LooseKind): WorkspaceId | undefined =>
  WORKSPACES.find((id) => (wings[id] as Entry).looks === kind);
