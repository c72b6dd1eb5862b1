import { createContext } from 'preact';
import { useContext, useEffect } from 'preact/hooks';
import type { App } from '../app/api';
import type { Wing } from '../app/wing';
import type { WorkspaceId } from '../recipe/recipe';
import { type Face, loadedFaces, loadFace } from './wings';

export const AppContext = createContext<App | null>(null);

export function useApp(): App {
  const app = useContext(AppContext);
  if (!app) throw new Error('components live inside AppContext');
  return app;
}

/** What the open wing has on the page; `undefined` for the moment until it is loaded. */
export function useFace(): Face | undefined {
  const { wings, messages } = useApp();
  const id = wings.open.value?.id;
  useEffect(() => {
    if (id) loadFace(id).catch((error: unknown) => messages.failed(error));
  }, [id, messages]);
  return id && loadedFaces.value[id];
}

/** A wing, for its own panels: they are on the page only once it is loaded. */
export function useWing<W extends Wing>(id: WorkspaceId): W {
  return useApp().wings.get(id) as W;
}

/** For lists of everything there is: wings that have not been needed yet join as they are loaded. */
export function useAllWings(): void {
  const { wings, messages } = useApp();
  useEffect(() => {
    wings.loadAll().catch((error: unknown) => messages.failed(error));
  }, [wings, messages]);
}
