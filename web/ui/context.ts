import { createContext } from 'preact';
import { useContext } from 'preact/hooks';
import type { App } from '../app/api';

export const AppContext = createContext<App | null>(null);

export function useApp(): App {
  const app = useContext(AppContext);
  if (!app) throw new Error('components live inside AppContext');
  return app;
}
