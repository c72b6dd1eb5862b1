// The page's start: kernel, viewport, app and interface meet here.

import { buildApp } from './app/app';
import { browserWorld, followFrameRate, keepOffline, listen } from './app/browser';
import { t } from './app/i18n';
import { start } from './app/start';
import { LissomError } from './core/errors';
import { startKernel } from './kernel/spawn';
import { renderApp } from './ui/app';
import type { ViewportPort } from './view/types';
import { Viewport } from './view/viewport';

/** `?test=1`: no motion, no antialiasing; for end-to-end tests. */
const test = new URLSearchParams(location.search).get('test') === '1';

const stage = document.createElement('div');
Object.assign(stage.style, { position: 'absolute', inset: '0' });
const canvas = document.createElement('canvas');
stage.append(canvas);

function makeViewport(): { viewport: ViewportPort | null; problem?: unknown } {
  try {
    return { viewport: new Viewport(canvas, { container: stage, test }) };
  } catch (error) {
    return { viewport: null, problem: error };
  }
}

const { viewport, problem } = makeViewport();
const app = buildApp(browserWorld({ kernel: startKernel(), viewport }));
listen(app);
followFrameRate(app);
renderApp(document.getElementById('app')!, app, stage);
if (problem) {
  app.messages.toast('bad', problem instanceof LissomError ? t('error.no-webgl') : String(problem));
}

canvas.addEventListener('webglcontextrestored', () => app.messages.toast('info', t('toast.picture-lost')));
const ready = start(app, location.href)
  .catch((error: unknown) => app.messages.failed(error))
  .then(() => app.gallery.start())
  .catch((error: unknown) => app.messages.failed(error));
if (import.meta.env.PROD) keepOffline(app);

/** For end-to-end tests to read the state by; nothing in the app uses it. */
Object.assign(window, { __lissom: { app, ready } });
