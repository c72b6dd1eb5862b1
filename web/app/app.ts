// Builds the app from its parts. The one place where services learn of each other.

import { effect } from '@preact/signals';
import type { KernelPort } from '../kernel/contract';
import type { Recipe } from '../recipe/recipe';
import { Runner } from '../run/evaluate';
import type { ViewportPort } from '../view/types';
import type { App } from './api';
import { Autosave } from './autosave';
import { busySign } from './busy-sign';
import { checkedStore } from './checked-store';
import { Commands } from './commands';
import { allCommands } from './commands/all';
import { Desk } from './desk';
import { Document, EMPTY } from './document';
import { Evaluator } from './evaluation';
import { syncFigures } from './figures';
import type { FileDialogs } from './file-dialogs';
import { Files } from './files';
import { Gallery } from './gallery';
import { t } from './i18n';
import { Keymap } from './keymap';
import { type MakingOptions, madeAside } from './making';
import { Messages } from './messages';
import { ModelStore } from './model-store';
import { type Pane, Panes } from './panes';
import { StoredSettings } from './settings';
import { Share } from './share';
import { besidesViewing, syncModel } from './shown-model';
import { State } from './state';
import { statusText } from './status';
import type { DocumentStore } from './store';
import type { Claims } from './tab-claim';
import { PointerSwitch } from './tools';
import { endViewingOnChange } from './viewing';
import type { BareModel, Gestures } from './wing';
import type { WingParts } from './wing-parts';
import { keepMounted, NOTHING_MOUNTED, type OnScreen, WingRoom } from './wing-room';
import { HOME, wings as registry } from './wings';
import { Workspaces } from './workspaces';

/** What the app needs of the world; `browser.ts` has the real one, tests make their own. */
export interface World {
  readonly kernel: KernelPort;
  readonly viewport: ViewportPort | null;
  /** Makes a viewport for one more model; called when it is first needed. */
  readonly pane: () => Pane | null;
  readonly store: DocumentStore;
  readonly claims: Claims;
  readonly dialogs: FileDialogs;
  /** Settings and the journal, which last; `null` where the browser forbids it. */
  readonly storage: Pick<Storage, 'getItem' | 'setItem' | 'removeItem' | 'key' | 'length'> | null;
  /** Of this tab, lasting over reloads. */
  readonly tab: Pick<Storage, 'getItem' | 'setItem'>;
  readonly galleryBase: string;
  readonly address: () => string;
  /** Hears of the link that the open document came from, so that the address leads to no other one. */
  readonly settleAddress: (link: string | undefined) => void;
  readonly copy: (text: string) => Promise<void>;
  /** Whether this tab was open before, and was reloaded. */
  readonly isReload: boolean;
  readonly persist: () => void;
  readonly newId: () => string;
  readonly now: () => number;
  readonly mac: boolean;
  readonly reload: () => void;
}

/** The app and what `main.tsx` beside the interface needs of it. */
export interface BuiltApp extends App {
  readonly document: Document;
  readonly wings: WingRoom;
  readonly keymap: Keymap;
  readonly autosave: Autosave;
  readonly gallery: Gallery;
  readonly desk: Desk;
  readonly evaluator: Evaluator;
  readonly dispose: () => void;
}

export function buildApp(world: World): BuiltApp {
  const { viewport } = world;
  const state = new State(EMPTY, HOME);
  const messages = new Messages(state);
  const failed = (error: unknown) => messages.failed(error);
  const settings = new StoredSettings(world.storage);
  const document = new Document(state);
  const gallery: Gallery = new Gallery(
    world.galleryBase,
    (recipe, title) =>
      whileBusy(t('busy.opening', { name: title }), ({ signal }) => desk.open({ recipe, title, signal })),
    ({ name, scalp = false }) => openingOf({ name, ref: { builtin: name }, scalp }),
    (entry, bytes) =>
      whileBusy(t('busy.making', { name: entry.title }), (options) => madeAside({ entry, bytes }, options)),
  );
  const models = new ModelStore((name) => gallery.model(name));
  const runner = new Runner({ kernel: world.kernel, models });
  const evaluator: Evaluator = new Evaluator({
    runner,
    state,
    strategyOf: (step) => wings.strategyOf(step),
    ready: () => wings.load(state.workspace.peek()),
    failed,
  });
  const result = besidesViewing(state, evaluator);
  const store = checkedStore(world.store, () => messages.toast('warn', t('error.stored-damaged')));
  const autosave = new Autosave({ ...world, store, state, document, models, messages });
  const room = () => wings;
  const desk = new Desk(state, document, runner, room, autosave, messages);
  const workspaces = new Workspaces({ state, document, wings: room });
  const panes = new Panes(world.pane);
  const onScreen: { now: () => OnScreen } = { now: () => NOTHING_MOUNTED };
  const pointer = viewport && pointerOf(viewport, state, settings, () => onScreen.now().tools);
  const gestures: Gestures = {
    cancel() {
      const active = [state.previewing.peek(), pointer?.cancel(), onScreen.now().cancel?.()];
      if (state.previewing.peek()) document.cancel();
      return active.some(Boolean);
    },
    back: () => onScreen.now().back?.() ?? false,
  };
  const parts: WingParts = {
    state,
    document,
    evaluator,
    runner,
    models,
    desk,
    workspaces,
    messages,
    settings,
    viewport,
    panes,
    gestures,
  };
  const wings: WingRoom = new WingRoom(registry, parts, failed);
  const files = new Files({
    state,
    document,
    models,
    desk,
    evaluator,
    viewport,
    messages,
    wings: room,
    dialogs: world.dialogs,
  });
  const share = new Share(document, messages, world);
  const context = { state, document, wings, workspaces, files, settings, viewport, gestures };
  const commands = new Commands({
    all: allCommands(context, () => wings.loaded.value.values()),
    failed,
    workspace: () => state.workspace.value,
  });
  const keymap = new Keymap(commands, settings, world.mac);

  /** Shows that something goes on, and the way out of it. */
  async function whileBusy<T>(label: string, work: (options: MakingOptions) => Promise<T>): Promise<T> {
    const abort = new AbortController();
    const sign = busySign(state.busy, label, () => abort.abort());
    try {
      return await work({ signal: abort.signal, onProgress: sign.progress });
    } finally {
      sign.end();
    }
  }

  /** What a bare model opens with: as the open workspace has it, else as the first one has. */
  async function openingOf(model: BareModel): Promise<Recipe> {
    const home = await wings.load(HOME);
    return (wings.open.peek()?.wing.opening?.(model) ?? home.opening?.(model))!;
  }

  const stops = [
    wings.follow(),
    syncFigures(state, evaluator, (shown) => wings.publish(shown)),
    endViewingOnChange(state),
    document.onCommit(() => {
      state.hint.value = null;
    }),
    effect(() => {
      const { tools = [] } = wings.open.value?.wing ?? {};
      if (tools.length > 0 && !tools.includes(state.tool.peek())) state.tool.value = tools[0]!;
    }),
    effect(() => {
      state.status.value = statusText(state, keymap, wings);
    }),
    effect(() => {
      const { theme } = settings.values.value;
      const display = state.display.peek();
      if (display.theme !== theme) state.display.value = { ...display, theme };
    }),
  ];
  if (viewport && pointer) {
    const model = syncModel(viewport, state, result);
    const mounted = keepMounted(viewport, state, wings.open);
    onScreen.now = mounted.now;
    viewport.setPointerHandler(pointer);
    stops.push(model, mounted.stop, () => viewport.setPointerHandler(null));
  }

  return {
    state,
    commands,
    keymap,
    document,
    wings,
    workspaces,
    files,
    autosave,
    share,
    settings,
    gallery,
    messages,
    viewport,
    panes,
    desk,
    evaluator,
    reload: () => void autosave.flush().then(world.reload),
    dispose: () => {
      for (const stop of stops) stop();
      for (const wing of wings.loaded.peek().values()) wing.dispose?.();
      evaluator.dispose();
      autosave.dispose();
    },
  };
}

/** The pointer of the main viewport goes to the tool in hand, unless something else is looked at. */
const pointerOf = (
  viewport: ViewportPort,
  state: State,
  settings: StoredSettings,
  tools: () => OnScreen['tools'],
) =>
  new PointerSwitch(
    viewport,
    () => (state.viewing.peek() ? undefined : tools()[state.tool.peek()]),
    settings,
  );
