// What a wing is to the rest of the app: one capability with its step types, tools, commands and pictures. The app
// never asks which wing it has in hand; what a wing offers beside is here, and left out where it offers nothing.

import type { Finding } from '../core/errors';
import type { Model } from '../core/model';
import type { ModelRef, Recipe, Step } from '../recipe/recipe';
import type { Tool } from '../tools/tool';
import type { ViewportPort } from '../view/types';
import type { Command, CommandGroup } from './commands';
import type { Evaluation, Strategy } from './evaluated';

export interface Gestures {
  /** Ends a gesture under way without a trace. @returns whether there was one */
  cancel(): boolean;
  /** Takes back the last stroke of something that is built in several. @returns whether there was one */
  back(): boolean;
}

/** What a wing has on screen while its workspace is open. */
export interface Mounted {
  /** By id: those that take the pointer of the main viewport. */
  readonly tools: Readonly<Record<string, Tool>>;
  /** Ends a gesture outside the main viewport's pointer: a gizmo's, a pane's. @returns whether there was one */
  cancel?(): boolean;
  /** Takes back the last stroke of what the taken tool builds in several. @returns whether there was one */
  back?(): boolean;
  /** Takes everything off the screen again: effects, layers, pointers. */
  unmount(): void;
}

/** A model that nothing has been done to yet. */
export interface BareModel {
  readonly name: string;
  readonly ref: ModelRef;
  /** It says where its scalp is. */
  readonly scalp?: boolean;
}

/** A file that was dropped or chosen and holds something beside a model, or no model at all. */
export interface LooseFile {
  readonly name: string;
  readonly bytes: Uint8Array;
  /** The model that it holds beside; `undefined`: none. */
  readonly model: Model | undefined;
  /** Opens it as a model all the same. */
  readonly openModel: () => Promise<void>;
}

/** One line of the export dialog. */
interface WrittenAs {
  /** The extension too. */
  readonly format: string;
  readonly label: string;
  readonly keeps: string;
  readonly mimeType: string;
}

/** What a wing writes beside models. */
export interface ExportGroup {
  readonly label: string;
  /** What the model is called beside it. */
  readonly besideLabel: string;
  readonly choices: readonly WrittenAs[];
  readonly about: string;
  /** A switch of the group, if there is one: its label. */
  readonly option?: string;
  /** @throws LissomError  where there is nothing to write */
  write(shown: Evaluation, name: string, format: string, option: boolean): Uint8Array | Promise<Uint8Array>;
}

export interface Wing {
  /** Ids of its tools; the first is the one that Escape leads back to. */
  readonly tools: readonly string[];
  /** What its commands are grouped under, beside the tools. */
  readonly group: CommandGroup;
  readonly commands: readonly Command[];
  // biome-ignore lint/suspicious/noExplicitAny: each wing's strategy knows its own steps only
  readonly strategy: Strategy<any>;
  /** Starts a step of its own, where the document has none. */
  start(): Promise<void>;
  /** A step of its own on a model, that does nothing yet: where a wing lets a model be changed before it uses it. */
  stepOn?(id: string, model: string): Step;
  /** Which of the document's steps of its own to open; the last one when left out. @returns `undefined`: none of them */
  last?(recipe: Recipe): string | undefined;
  /** Whether a step of its own does nothing yet: what follows starts from what came in. */
  isIdle?(step: Step): boolean;
  /** Of a step of its own that leaves several models: what the one is called that others go on with. Reads signals. */
  resultOf?(step: Step): string | undefined;
  /** Those models, as far as they are there, to be exported one by one. Reads signals. */
  results?(): readonly Model[];
  /** The recipe that a model opens with in its workspace; left out or `undefined`: that of the first workspace. */
  opening?(model: BareModel): Recipe | undefined;
  /** Follows the results: its own figures. `null` while the open step is not its own. */
  publish?(shown: Evaluation | null): void;
  /** Which of the kernel's findings are news in its workspace; all when left out. */
  warnings?(shown: Evaluation): readonly Finding[];
  /** The status bar's sentence; reads signals. @param key  the shortcut of a command as it is shown */
  status(key: (command: string) => string): string;
  /** What Escape ends beside gestures. @returns whether there was anything */
  escape?(): boolean;
  /** Vertices of the selected item, to frame them; `undefined` where nothing is selected. */
  selected?(): Uint32Array | undefined;
  /** Frames what it shows beside the main viewport, where that is framed. */
  fit?(): void;
  /** Whether the tools' mirror is of use. */
  readonly mirrors?: boolean;
  /** What else is written beside models while its workspace is open. Reads signals. */
  readonly exports?: ExportGroup | undefined;
  /** Takes such a file: to be looked at in place of the document, or opened as a model after all. */
  take?(file: LooseFile): Promise<void>;
  /** Puts itself on screen. */
  mount(viewport: ViewportPort): Mounted;
  /** Ends what follows the document while its workspace is closed. */
  dispose?(): void;
}
