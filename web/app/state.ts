// What the app knows, as signals: components read them, the app's services write them. No behaviour here.
// Actions are in api.ts (`app.deform`, `app.files` …) and, for everything with a name, in commands.ts.

import { computed, type ReadonlySignal, type Signal, signal } from '@preact/signals';
import type { Finding } from '../core/errors';
import type { Model } from '../core/model';
import { stepOf } from '../recipe/edit';
import type { DeformStep, HairStep, MergeStep, Recipe } from '../recipe/recipe';
import type { DisplayOptions, GizmoMode } from '../view/types';
import { HairState } from './hair/state';
import { hairStepById } from './hair/steps';
import type { MessageKey } from './i18n';
import { MergeState } from './merge/state';
import { mergeStepById } from './merge/steps';

export type WorkspaceId = 'deform' | 'hair' | 'merge';

/** The tools of each workspace; the first is the one that Escape leads back to. */
export const TOOLS = {
  deform: ['select', 'paint-roi', 'paint-handle', 'point-handle'],
  hair: ['hair-select', 'stream', 'hint', 'parting', 'ponytail', 'paint-scalp', 'paint-length'],
  merge: ['merge-pins', 'mark-region', 'mark-feature'],
} as const satisfies Readonly<Record<WorkspaceId, readonly string[]>>;
export type ToolId = (typeof TOOLS)[WorkspaceId][number];
export type DialogId =
  | 'gallery'
  | 'export'
  | 'share'
  | 'import-report'
  | 'help'
  | 'settings'
  | 'palette'
  | 'restore';

/** Which step is open and which of its handles is selected. Part of the undo history. */
export interface Selection {
  /** Id of the open step; `''` while the recipe has none. */
  readonly step: string;
  /** Index into the open step's handles; in a hair step into its streams, partings and ponytails, in this order; in a merge step its pin. */
  readonly handle: number | null;
}

/** One state of the document: what undo goes back to. */
export interface Snapshot {
  readonly recipe: Recipe;
  readonly selection: Selection;
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

/** What the open step did to its model. */
export interface WhatItDid {
  /** 1 = unchanged; of no meaning for an open surface (see `closed`). */
  readonly volumeRatio: number;
  readonly closed: boolean;
  /** l/l₀ − 1 of the edge whose length changed most: above 0 stretched, below squeezed. */
  readonly worstStretch: number;
  readonly edgeRms: number;
  readonly flippedTriangles: number;
  readonly handlesMet: number;
  readonly handles: number;
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
  /** The open step while it is one that deforms. */
  readonly step: ReadonlySignal<DeformStep | undefined> = computed(() =>
    stepOf(this.recipe.value, this.selection.value.step, 'deform'),
  );

  /** The open step while it is one that grows hair. */
  readonly hairStep: ReadonlySignal<HairStep | undefined> = computed(() =>
    hairStepById(this.recipe.value, this.selection.value.step),
  );

  /** The open step while it is one that merges. */
  readonly mergeStep: ReadonlySignal<MergeStep | undefined> = computed(() =>
    mergeStepById(this.recipe.value, this.selection.value.step),
  );

  // The workspace
  readonly hair = new HairState();
  readonly merge = new MergeState(this.mergeStep);
  /** Whether a part to add is being chosen: the merge step begins with it. */
  readonly choosing: ReadonlySignal<boolean> = computed(
    () => this.merge.choosing.value?.recipe === this.recipe.value,
  );
  /** That of the open step, or of the one being started. */
  readonly workspace: ReadonlySignal<WorkspaceId> = computed(() => {
    if (this.choosing.value || this.mergeStep.value) return 'merge';
    return this.hairStep.value ? 'hair' : 'deform';
  });
  readonly tool = signal<ToolId>('select');
  readonly gizmo = signal<GizmoMode>('translate');
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
  readonly heat = signal(false);
  /** Range of the heat map's legend: mean edge stretch, l/l₀ − 1. */
  readonly heatRange = signal<readonly [number, number]>([-0.5, 0.5]);
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
  readonly whatItDid = signal<WhatItDid | null>(null);
  /** Per source vertex: mean of l/l₀ − 1 over its edges, for the heat map. */
  readonly stretch = signal<Float32Array | null>(null);
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

  constructor(first: Snapshot) {
    this.shown = signal(first);
  }
}
