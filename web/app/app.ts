// Builds the app from its parts. The one place where services learn of each other.

import { effect, signal } from '@preact/signals';
import type { KernelPort } from '../kernel/contract';
import { Runner } from '../run/evaluate';
import type { ViewportPort } from '../view/types';
import type { App } from './api';
import { Autosave } from './autosave';
import { checkedStore } from './checked-store';
import { Commands } from './commands';
import { allCommands } from './commands/all';
import { DeformActions } from './deform-actions';
import { AppDeformHost } from './deform-host';
import { Desk } from './desk';
import { Document, EMPTY } from './document';
import { Evaluator } from './evaluation';
import { syncFigures } from './figures';
import type { FileDialogs } from './file-dialogs';
import { Files } from './files';
import { Gallery, recipeOn } from './gallery';
import { HairActions } from './hair/actions';
import { syncField } from './hair/field-sync';
import { AppHairHost } from './hair/host';
import { AppLengthHost } from './hair/length-host';
import { hideCurvesAtFirst } from './hair/opening';
import { syncHair } from './hair/view-sync';
import { besidesViewed, endViewingOnChange, syncViewed } from './hair/viewed';
import { t } from './i18n';
import { Keymap } from './keymap';
import { MergeActions } from './merge/actions';
import { type Panes, syncPanes } from './merge/panes';
import { Messages } from './messages';
import { ModelStore } from './model-store';
import { StoredSettings } from './settings';
import { Share } from './share';
import { State, TOOLS, type ToolId } from './state';
import { statusText } from './status';
import type { DocumentStore } from './store';
import type { Claims } from './tab-claim';
import { ToolSwitch } from './tools';
import { syncView } from './view-sync';
import { hairRecipeOn, Workspaces } from './workspaces';

/** What the app needs of the world; `browser.ts` has the real one, tests make their own. */
export interface World {
  readonly kernel: KernelPort;
  readonly viewport: ViewportPort | null;
  /** Makes the viewports of the two models to be merged; called when they are first needed. */
  readonly panes: () => Panes | null;
  readonly store: DocumentStore;
  readonly claims: Claims;
  readonly dialogs: FileDialogs;
  /** Settings that last; `null` where the browser forbids it. */
  readonly storage: Pick<Storage, 'getItem' | 'setItem'> | null;
  /** Of this tab, lasting over reloads. */
  readonly tab: Pick<Storage, 'getItem' | 'setItem'>;
  readonly galleryBase: string;
  readonly address: () => string;
  readonly copy: (text: string) => Promise<void>;
  readonly persist: () => void;
  readonly newId: () => string;
  readonly now: () => number;
  readonly mac: boolean;
  readonly reload: () => void;
}

/** The app and what `main.tsx` beside the interface needs of it. */
export interface BuiltApp extends App {
  readonly document: Document;
  readonly deform: DeformActions;
  readonly merge: MergeActions;
  readonly keymap: Keymap;
  readonly autosave: Autosave;
  readonly gallery: Gallery;
  readonly desk: Desk;
  readonly evaluator: Evaluator;
  readonly dispose: () => void;
}

export function buildApp(world: World): BuiltApp {
  const { viewport } = world;
  const state = new State(EMPTY);
  const messages = new Messages(state);
  const failed = (error: unknown) => messages.failed(error);
  const settings = new StoredSettings(world.storage);
  const document = new Document(state);
  const gallery: Gallery = new Gallery(
    world.galleryBase,
    (recipe, title) => desk.open({ recipe, title }),
    ({ name, scalp }) => (scalp && state.workspace.peek() === 'hair' ? hairRecipeOn(name) : recipeOn(name)),
  );
  const models = new ModelStore((name) => gallery.model(name));
  const runner = new Runner({ kernel: world.kernel, models });
  const evaluator = new Evaluator(runner, state, failed);
  const store = checkedStore(world.store, () => messages.toast('warn', t('error.stored-damaged')));
  const autosave = new Autosave({ ...world, store, state, document, models, messages });
  const desk = new Desk(state, document, runner, autosave, messages);
  const deform = new DeformActions(document, evaluator);
  const hair = new HairActions({ state, document, evaluator, models, viewport });
  const merge = new MergeActions({ state, document, runner });
  const workspaces = new Workspaces({ state, document, desk, evaluator, messages, merge });
  const files = new Files({
    state,
    document,
    models,
    desk,
    evaluator,
    viewport,
    messages,
    merge,
    dialogs: world.dialogs,
  });
  const share = new Share(document, messages, world);
  const stops = [
    syncFigures(state, evaluator, runner, failed),
    hideCurvesAtFirst(state),
    endViewingOnChange(state),
    document.onCommit(() => {
      state.hint.value = null;
    }),
  ];

  let cancelGesture = () => false;
  let goBack = () => false;
  if (viewport) {
    const host = new AppDeformHost(viewport, state, document, evaluator);
    const hairHost = new AppHairHost({ viewport, state, document, evaluator, messages });
    const lengths = new AppLengthHost({ state, document, hair: hairHost });
    const tools = new ToolSwitch({ view: viewport, deform: host, hair: hairHost, lengths, state, settings });
    const own = { result: besidesViewed(state, evaluator) };
    const view = syncView({ viewport, state, evaluator: own, host });
    const stopHair = syncHair({ viewport, state, evaluator: own, host: hairHost });
    goBack = () => tools.back();
    viewport.setPointerHandler(tools);
    cancelGesture = () => {
      const active = tools.busy || state.previewing.peek();
      tools.cancel();
      view.gizmo.onCancel();
      if (state.previewing.peek()) document.cancel();
      return active;
    };
    const stopField = syncField({ viewport, state, evaluator: own, runner, failed });
    const stopViewed = syncViewed(viewport, state);
    stops.push(view.stop, stopHair, stopField, stopViewed, () => viewport.setPointerHandler(null));
  }

  const panes = signal<Panes | null>(null);
  const cancelMain = cancelGesture;
  stops.push(
    effect(() => {
      if (state.workspace.value !== 'merge' || panes.peek()) return;
      panes.value = world.panes();
      if (!panes.value) return;
      const synced = syncPanes(panes.value, { state, document, actions: merge, settings });
      stops.push(synced.stop);
      cancelGesture = () => [synced.cancel(), cancelMain()].some((active) => active);
    }),
  );

  const gestures = { cancel: () => cancelGesture(), back: () => goBack() };
  const context = { state, document, deform, hair, merge, workspaces, files, settings, viewport, gestures };
  const commands = new Commands(allCommands(context), failed, () => state.workspace.value);
  const keymap = new Keymap(commands, settings, world.mac);
  stops.push(
    effect(() => {
      state.status.value = statusText(state, keymap);
    }),
    effect(() => {
      const tools: readonly ToolId[] = TOOLS[state.workspace.value];
      if (!tools.includes(state.tool.peek())) state.tool.value = tools[0]!;
    }),
    effect(() => {
      const { theme } = settings.values.value;
      const display = state.display.peek();
      if (display.theme !== theme) state.display.value = { ...display, theme };
    }),
  );

  return {
    state,
    commands,
    keymap,
    document,
    deform,
    hair,
    merge,
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
      evaluator.dispose();
    },
  };
}
