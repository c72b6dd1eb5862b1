// The page's start: kernel, viewport, app and interface meet here.

import { buildApp } from './app/app';
import { browserWorld, followFrameRate, keepOffline, listen } from './app/browser';
import { t } from './app/i18n';
import type { Pane } from './app/panes';
import { start } from './app/start';
import { LissomError } from './core/errors';
import { startKernel } from './kernel/spawn';
import { renderApp } from './ui/app';
import { Viewport } from './view/viewport';

/** `?test=1`: no motion, no antialiasing; for end-to-end tests. */
const test = new URLSearchParams(location.search).get('test') === '1';

function place(): { readonly frame: HTMLElement; readonly canvas: HTMLCanvasElement } {
  const frame = document.createElement('div');
  frame.className = 'viewport';
  const canvas = document.createElement('canvas');
  frame.append(canvas);
  return { frame, canvas };
}

/** @throws LissomError  `webgl-missing` */
const viewportIn = ({ frame, canvas }: ReturnType<typeof place>) =>
  new Viewport(canvas, { container: frame, test });

function makePane(): Pane | null {
  const held = place();
  try {
    return { frame: held.frame, viewport: viewportIn(held) };
  } catch {
    return null;
  }
}

const main = place();
let viewport: Viewport | null = null;
let problem: unknown;
try {
  viewport = viewportIn(main);
} catch (error) {
  problem = error;
}
const app = buildApp(browserWorld({ kernel: startKernel(), viewport, pane: makePane }));
listen(app);
followFrameRate(app);
renderApp(document.getElementById('app')!, app, main.frame);
if (problem) {
  app.messages.toast('bad', problem instanceof LissomError ? t('error.no-webgl') : String(problem));
}

main.canvas.addEventListener('webglcontextrestored', () =>
  app.messages.toast('info', t('toast.picture-lost')),
);
const ready = start(app, location.href)
  .catch((error: unknown) => app.messages.failed(error))
  .then(() => app.gallery.start())
  .catch((error: unknown) => app.messages.failed(error));
if (import.meta.env.PROD) keepOffline(app);

/** For end-to-end tests to read the state by; nothing in the app uses it. */
Object.assign(window, { __lissom: { app, ready } });
