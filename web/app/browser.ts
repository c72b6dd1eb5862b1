// The app in a real page: what it needs of the browser, and the browser's events that it listens to.

import { effect } from '@preact/signals';
import { hasLink } from '../recipe/link/link';
import type { BuiltApp, World } from './app';
import { browserDialogs } from './file-dialogs';
import { t } from './i18n';
import { openLink } from './start';
import { BrowserStore } from './store';
import { tabClaims } from './tab-claim';
import { scriptOf, watchForUpdate } from './update-check';

export function browserWorld(parts: Pick<World, 'kernel' | 'viewport' | 'pane'>): World {
  const page = () => location.href.replace(/[?#].*$/s, '');
  return {
    ...parts,
    store: new BrowserStore(),
    claims: tabClaims(newId()),
    dialogs: browserDialogs,
    storage: storageOf(() => localStorage),
    tab: storageOf(() => sessionStorage) ?? { getItem: () => null, setItem: () => {} },
    galleryBase: new URL('gallery/', page()).href,
    address: page,
    settleAddress: (link = '') => {
      if (hasLink(location.hash) && location.hash !== link)
        history.replaceState(history.state, '', page() + location.search + link);
    },
    copy: (text) => navigator.clipboard.writeText(text),
    isReload: performance
      .getEntriesByType('navigation')
      .some((entry) => (entry as PerformanceNavigationTiming).type === 'reload'),
    persist: () => void navigator.storage?.persist?.(),
    newId,
    now: () => Date.now(),
    mac: /Mac|iPhone|iPad/.test(navigator.platform),
    reload: () => location.reload(),
  };
}

/** Keys, dropped files, links pasted into the address bar, leaving the page. */
export function listen(app: BuiltApp): void {
  const { state, messages } = app;
  window.addEventListener('keydown', (event) => {
    // A dialog keeps its keys to itself; Escape closes it.
    if (state.dialog.value !== null || event.defaultPrevented || event.isComposing) return;
    const command = app.keymap.commandFor(event, focused());
    if (!command) return;
    event.preventDefault();
    void app.commands.run(command);
  });
  window.addEventListener('dragover', (event) => {
    if (!event.dataTransfer?.types.includes('Files')) return;
    event.preventDefault();
    state.dropping.value = true;
  });
  window.addEventListener('dragleave', (event) => {
    if (event.relatedTarget === null) state.dropping.value = false;
  });
  window.addEventListener('drop', (event) => {
    state.dropping.value = false;
    const files = [...(event.dataTransfer?.files ?? [])];
    if (files.length === 0) return;
    event.preventDefault();
    void app.files.openFiles(files);
  });
  window.addEventListener('hashchange', () => {
    if (hasLink(location.hash)) void openLink(app, location.hash).then(() => app.autosave.settleAddress());
  });
  const leave = () => {
    app.autosave.lastWord();
    void app.autosave.flush();
  };
  window.addEventListener('pagehide', leave);
  window.addEventListener('beforeunload', (event) => {
    app.autosave.lastWord();
    if (app.autosave.isAtRisk) event.preventDefault();
  });
  document.addEventListener('visibilitychange', () => {
    if (document.visibilityState === 'hidden') leave();
  });
  window.addEventListener('error', ({ error, message }) => messages.failed(error ?? new Error(message)));
  window.addEventListener('unhandledrejection', ({ reason }) => messages.failed(reason));
  effect(() => {
    document.documentElement.dataset.theme = app.settings.values.value.theme;
  });
  effect(() => {
    const title = state.title.value;
    document.title = title ? `${title} · ${t('app.name')}` : t('app.name');
  });
}

/** How many frames were drawn in the last second, while any are. */
export function followFrameRate({ state, viewport }: BuiltApp): void {
  if (!viewport) return;
  setInterval(() => {
    const fps = viewport.frameRate;
    if (fps !== state.figures.peek().fps) state.figures.value = { ...state.figures.peek(), fps };
  }, 500);
}

/** Offline use, and word of a newer version. For the built page only. */
export function keepOffline(app: BuiltApp): void {
  const offline = navigator.serviceWorker;
  // A newer service worker asks which version each page is, before it clears older ones away.
  offline?.addEventListener('message', ({ ports }) =>
    ports[0]?.postMessage(scriptOf(document.documentElement.outerHTML)),
  );
  offline?.register('sw.js').catch(() => {
    // A browser that forbids it still has the page, only not offline.
  });
  watchForUpdate(document, () => {
    app.state.updateReady.value = true;
  });
}

function focused() {
  const element = document.activeElement;
  if (!(element instanceof HTMLElement) || element === document.body || element.tagName === 'CANVAS')
    return null;
  const { tagName, isContentEditable } = element;
  return { tagName, isContentEditable, ...(element instanceof HTMLInputElement && { type: element.type }) };
}

function storageOf(open: () => Storage): Storage | null {
  try {
    return open();
  } catch {
    return null;
  }
}

/** Names for stored documents, different in every tab. */
function newId(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(12));
  return [...bytes].map((byte) => byte.toString(16).padStart(2, '0')).join('');
}
