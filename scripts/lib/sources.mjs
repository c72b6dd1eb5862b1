// The program's own TypeScript for scripts: read as it stands, with nothing built before.

import { createServer } from 'vite';
import { root } from './system.mjs';

/** @returns a server with `ssrLoadModule('/web/…')`; to be closed by whoever opened it */
export const openSources = () =>
  createServer({
    root,
    configFile: false,
    logLevel: 'error',
    server: { middlewareMode: true, hmr: false, ws: false, watch: null },
    optimizeDeps: { noDiscovery: true },
    appType: 'custom',
  });
