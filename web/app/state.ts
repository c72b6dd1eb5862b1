// What the app knows, as signals: components read them, the app's services write them. No behaviour here.
// Actions are in api.ts (`app.files`, `app.document` …) and, for everything with a name, in commands.ts. What one wing
// knows beside this is in its own folder.

import { computed, type ReadonlySignal, type Signal, signal } from '@preact/signals';
import type { Finding } from '../core/errors';
import type { Model } from '../core/model';
import { stepById } from '../recipe/edit';
import { type ModelRef, type Recipe, type Step, type WorkspaceId, workspaceOf } from '../recipe/recipe';
import type { DisplayOptions, ViewportPort } from '../view/types';
import type { MessageKey } from './i18n';

export type DialogId =
  | 'gallery'
  | 'export'
  | 'share'
  | 'import-report'
  | 'help'
  | 'settings'
  | 'palette'
  | 'restore';

/** Which step is open and which of its items is selected. Part of the undo history. */
export interface Selection {
  /** Id of the open step; `''` while the recipe has none. */
  readonly step: string;
  /** Number of an item of the open step, as its wing counts them: a handle, a curve, a pin. */
  readonly item: number | null;
}

/** One state of the document: what undo goes back to. */
export interface Snapshot {
  readonly recipe: Recipe;
  readonly selection: Selection;
}

/** A model is being chosen for a step that begins with it, for as long as the recipe stays this one. */
export interface ModelChoice {
  readonly recipe: Recipe;
  /** Where the step belongs. */
  readonly workspace: WorkspaceId;
  /** What a file that is dropped now becomes. */
  readonly drop: MessageKey;
  choose(name: string, ref: ModelRef): void;
}

/** A file looked at in place of the document, which stays as it is. */
export interface Viewing {
  /** What is on screen, as a sentence. */
  readonly said: string;
  readonly back: string;
  /** The status bar's sentence. @param key  the shortcut of a command as it is shown */
  status(key: (command: string) => string): string;
  /** @returns the function that takes it off the screen */
  mount(viewport: ViewportPort): () => void;
}

/** Work long enough to be shown: a label, how far it is, a way out. */
export interface Busy {
  readonly label: string;
  /** In [0, 1]; `null` while unknown. */
  readonly fraction: number | null;
  readonly cancel: (() => void) | null;
}

export interface Toast {
  readonly id: number;
  readonly kind: 'info' | 'good' | 'warn' | 'bad';
  readonly text: string;
  readonly action?: { readonly label: string; readonly run: () => void };
}

/** The status bar's numbers; `null` where nothing has been measured. Times in milliseconds. */
export interface Figures {
  readonly vertices: number | null;
  readonly faces: number | null;
  readonly free: number | null;
  readonly factor: number | null;
  readonly solve: number | null;
  /** One live step of the last drag, from request to picture. */
  readonly drag: number | null;
  readonly fps: number;
}

/** The model the open step starts from, as shown in the Model panel. */
export interface ModelFacts {
  readonly name: string;
  readonly vertices: number;
  readonly faces: number;
  readonly components: number;
  readonly boundaryLoops: number;
  readonly closed: boolean;
}

export interface ImportReport {
  readonly file: string;
  readonly facts: ModelFacts;
  /** `message` where the reader had more to say than the code does. */
  readonly findings: readonly (Finding & { readonly message?: string })[];
}

/** Where the work is. `time` in ms since 1970. */
export type SavedState =
  | { readonly kind: 'clean' }
  | { readonly kind: 'unsaved' }
  | { readonly kind: 'saving' }
  | { readonly kind: 'saved'; readonly time: number }
  | { readonly kind: 'failed'; readonly message: string };

export type BrushMode = 'add' | 'erase';

/** Signals, grouped by who shows them. */
export class State {
  // The document
  /** What is drawn and listed: the preview of a gesture under way, else the committed document. */
  readonly shown: Signal<Snapshot>;
  /** True while a gesture previews an edit that is not yet history. */
  readonly previewing = signal(false);
  readonly canUndo = signal(false);
  readonly canRedo = signal(false);
  /** What undo and redo would take back or bring again; `''` when nothing. */
  readonly undoLabel = signal('');
  readonly redoLabel = signal('');
  readonly title = signal('');
  /** How many documents have been laid open: with each, what is shown starts over. */
  readonly opened = signal(0);
  readonly saved = signal<SavedState>({ kind: 'clean' });

  readonly recipe: ReadonlySignal<Recipe> = computed(() => this.shown.value.recipe);
  readonly selection: ReadonlySignal<Selection> = computed(() => this.shown.value.selection);
  /** The open step. */
  readonly step: ReadonlySignal<Step | undefined> = computed(() =>
    stepById(this.recipe.value, this.selection.value.step),
  );

  // The workspace
  /** A model that is asked for; see `choosing`. */
  readonly choice = signal<ModelChoice | null>(null);
  /** The same, while it holds: an edit of the recipe ends it. */
  readonly choosing: ReadonlySignal<ModelChoice | null> = computed(() => {
    const choice = this.choice.value;
    return choice?.recipe === this.recipe.value ? choice : null;
  });
  /** That of the open step, or of the one being started. */
  readonly workspace: ReadonlySignal<WorkspaceId> = computed(
    () => this.choosing.value?.workspace ?? workspaceOf(this.step.value) ?? this.home,
  );
  readonly viewing = signal<Viewing | null>(null);
  /** One of the open workspace's; `''` before there is any. */
  readonly tool = signal('');
  /** Brush radius in CSS pixels. */
  readonly brushSize = signal(28);
  readonly brushMode = signal<BrushMode>('add');
  readonly mirror = signal(false);
  readonly display = signal<DisplayOptions>({
    shading: 'clay',
    smooth: true,
    wireframe: false,
    grid: true,
    theme: 'dark',
  });
  /** One short line over the viewport until the first drag. */
  readonly hint = signal<MessageKey | null>(null);

  // Results
  readonly model = signal<Model | null>(null);
  readonly facts = signal<ModelFacts | null>(null);
  readonly importReport = signal<ImportReport | null>(null);
  readonly figures = signal<Figures>({
    vertices: null,
    faces: null,
    free: null,
    factor: null,
    solve: null,
    drag: null,
    fps: 0,
  });
  /** Warnings of the open step (degenerate handles, components without a handle …). */
  readonly warnings = signal<readonly Finding[]>([]);

  // Messages
  readonly busy = signal<Busy | null>(null);
  readonly toasts = signal<readonly Toast[]>([]);
  /** What a click and a drag do now. */
  readonly status = signal('');
  readonly dialog = signal<DialogId | null>(null);
  /** True while a file hovers over the window. */
  readonly dropping = signal(false);
  readonly updateReady = signal(false);
  readonly locale = signal('en');

  /** @param home  the workspace of a document that says nothing else */
  constructor(
    first: Snapshot,
    readonly home: WorkspaceId,
  ) {
    this.shown = signal(first);
  }
}
