// The page's start: kernel, viewport, app and interface meet here.

import { buildApp } from './app/app';
import { browserWorld, followFrameRate, keepOffline, listen } from './app/browser';
import { t } from './app/i18n';
import type { Panes } from './app/merge/panes';
import { start } from './app/start';
import { LissomError } from './core/errors';
import { startKernel } from './kernel/spawn';
import { renderApp } from './ui/app';
import type { ViewportPort } from './view/types';
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

const places = { main: place(), source: place(), target: place() };
const viewportIn = ({ frame, canvas }: ReturnType<typeof place>): ViewportPort =>
  new Viewport(canvas, { container: frame, test });

function makeViewport(): { viewport: ViewportPort | null; problem?: unknown } {
  try {
    return { viewport: viewportIn(places.main) };
  } catch (error) {
    return { viewport: null, problem: error };
  }
}

/** Browsers give a page a limited number of 3D canvases: these are made when two models are to be merged. */
function makePanes(): Panes | null {
  try {
    return { source: viewportIn(places.source), target: viewportIn(places.target) };
  } catch {
    return null;
  }
}

const { viewport, problem } = makeViewport();
const app = buildApp(browserWorld({ kernel: startKernel(), viewport, panes: makePanes }));
listen(app);
followFrameRate(app);
renderApp(document.getElementById('app')!, app, {
  main: places.main.frame,
  source: places.source.frame,
  target: places.target.frame,
});
if (problem) {
  app.messages.toast('bad', problem instanceof LissomError ? t('error.no-webgl') : String(problem));
}

places.main.canvas.addEventListener('webglcontextrestored', () =>
  app.messages.toast('info', t('toast.picture-lost')),
);
const ready = start(app, location.href)
  .catch((error: unknown) => app.messages.failed(error))
  .then(() => app.gallery.start())
  .catch((error: unknown) => app.messages.failed(error));
if (import.meta.env.PROD) keepOffline(app);

/** For end-to-end tests to read the state by; nothing in the app uses it. */
Object.assign(window, { __lissom: { app, ready } });
