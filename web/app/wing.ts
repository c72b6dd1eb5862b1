// What a wing is to the rest of the app: one capability with its step types, tools, commands and pictures. The app
// never asks which wing it has in hand; what a wing offers beside is here, and left out where it offers nothing.

import type { ReadonlySignal } from '@preact/signals';
import type { Finding, LissomError } from '../core/errors';
import type { Strands } from '../core/strands';
import type { ModelRef, Recipe, Step } from '../recipe/recipe';
import type { Runner } from '../run/evaluate';
import type { StepReport } from '../run/results';
import type { ModelResult } from '../run/types';
import type { Tool } from '../tools/tool';
import type { ViewportPort } from '../view/types';
import type { MessageService, SettingsService, WorkspaceService } from './api';
import type { Command, CommandGroup } from './commands';
import type { Desk } from './desk';
import type { Document } from './document';
import type { MessageKey } from './i18n';
import type { ModelStore } from './model-store';
import type { Panes } from './panes';
import type { State } from './state';

/** The shared rooms that a wing is built on. */
export interface WingParts {
  readonly state: State;
  readonly document: Document;
  readonly evaluator: EvaluatorPort;
  readonly runner: RunnerPort;
  readonly models: ModelStore;
  readonly desk: Desk;
  readonly workspaces: WorkspaceService;
  readonly messages: MessageService;
  readonly settings: SettingsService;
  readonly viewport: ViewportPort | null;
  readonly panes: Panes;
  readonly gestures: Gestures;
}

export type RunnerPort = Pick<Runner, 'run' | 'opened' | 'ask'>;

export interface EvaluatorPort {
  readonly result: ReadonlySignal<Evaluation | null>;
  /** Resolves once nothing runs or waits. */
  settled(): Promise<void>;
}

export interface Gestures {
  /** Ends a gesture under way without a trace. @returns whether there was one */
  cancel(): boolean;
  /** Takes back the last stroke of something that is built in several. @returns whether there was one */
  back(): boolean;
}

/** The open step's result. */
export interface Evaluation {
  readonly recipe: Recipe;
  readonly step: Step;
  /** The models that came in, in the order of the step's references. */
  readonly inputs: readonly ModelResult[];
  /** The model on screen: what the step leaves where it makes a new surface, else the one it changes. */
  readonly shown: ModelResult;
  /** Where the vertices of the model on screen are. */
  readonly positions: Float64Array;
  /** Of a step that grows some. */
  readonly strands: Strands | null;
  /** `null` for a step that does nothing yet. */
  readonly report: StepReport | null;
  /** Why the step could not be run as it is asked for, where its inputs are shown instead. */
  readonly problem: LissomError | null;
  /** False while a gesture is under way, and while only the first of the strands are there. */
  readonly settled: boolean;
  /** Milliseconds from request to result. */
  readonly elapsed: number;
}

/** What a strategy makes of a step; the rest of an evaluation is the evaluator's. */
export type Outcome = Pick<Evaluation, 'inputs' | 'shown' | 'positions'> &
  Partial<Pick<Evaluation, 'strands' | 'report' | 'problem' | 'settled'>>;

/** A state of the open step that is to be shown. */
export interface Request<S extends Step = Step> {
  readonly recipe: Recipe;
  readonly step: S;
  /** A gesture is under way: the next request comes soon. */
  readonly live: boolean;
  /** What the strategy's `wish` said. */
  readonly wish: string;
}

export interface Evaluating {
  readonly runner: RunnerPort;
  readonly signal: AbortSignal;
  /** @param fraction  in [0, 1] */
  readonly onProgress: (fraction: number) => void;
  /** Whether there is time for the whole result; else a quick preview will do. */
  readonly settle: boolean;
  /** What is on screen. */
  readonly before: Evaluation | null;
  /** Shows something on the way, unless the request has been given up. */
  show(outcome: Outcome): void;
}

/** How a wing's steps are computed for the screen. */
export interface Strategy<S extends Step = Step> {
  /** What long work is called. */
  readonly busy: MessageKey;
  /** What of the result is asked for, beside what the recipe says; reads signals. Other wishes, other requests. */
  wish?(step: S): string;
  /**
   * Whether what may still be under way for `last` is of use for `next`, both of the same step type. A factorization
   * for handles that are no longer asked for, or all the strands of a style that has changed since, are not.
   */
  worthWaiting(last: Request<S>, next: Request<S>): boolean;
  run(request: Request<S>, evaluating: Evaluating): Promise<Outcome>;
  /** The work was stopped by hand. */
  stopped?(step: S): void;
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
  /** It holds no model. */
  readonly only: boolean;
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
  /** A switch of the group: its label. */
  readonly option: string;
  /** @throws LissomError  where there is nothing to write */
  write(shown: Evaluation, name: string, format: string, option: boolean): Uint8Array;
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
  /** Which of the document's steps of its own to open; the last one when left out. @returns `undefined`: none of them */
  last?(recipe: Recipe): string | undefined;
  /** Whether a step of its own does nothing yet: what follows starts from what came in. */
  isIdle?(step: Step): boolean;
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
  /** Whether the tools' mirror is of use. */
  readonly mirrors?: boolean;
  /** What else is written beside models while its workspace is open. */
  readonly exports?: ExportGroup;
  /** Takes such a file: to be looked at in place of the document, or opened as a model after all. */
  take?(file: LooseFile): Promise<void>;
  /** Puts itself on screen. */
  mount(viewport: ViewportPort): Mounted;
  /** Ends what follows the document while its workspace is closed. */
  dispose?(): void;
}
