// The app as components see it: signals to read (`state`), services to call. `main.ts` builds it; tests and components
// under test may hand in doubles. What a wing offers beside is in its own folder; its panels know it.

import type { ReadonlySignal } from '@preact/signals';
import type { Model } from '../core/model';
import type { Recipe, Step, WorkspaceId } from '../recipe/recipe';
import type { ViewportPort } from '../view/types';
import type { Commands } from './commands';
import type { Panes } from './panes';
import type { State, Toast } from './state';
import type { ExportGroup, Wing } from './wing';

export interface App {
  readonly state: State;
  readonly commands: Commands;
  readonly keymap: KeymapService;
  readonly document: DocumentService;
  readonly wings: WingService;
  readonly workspaces: WorkspaceService;
  readonly files: FileService;
  readonly autosave: AutosaveService;
  readonly share: ShareService;
  readonly settings: SettingsService;
  readonly gallery: GalleryService;
  readonly messages: MessageService;
  /** `null` where WebGL 2 is missing: panels, files and links still work. */
  readonly viewport: ViewportPort | null;
  /** More viewports, for models side by side. */
  readonly panes: Panes;
  /** Loads the newer version that `state.updateReady` announced. */
  reload(): void;
}

export interface WingService {
  /** The one whose workspace is open; `null` for the moment until it is loaded. Reads signals. */
  readonly open: ReadonlySignal<{ readonly id: WorkspaceId; readonly wing: Wing } | null>;
  /** One that is loaded. Reads signals. */
  get(id: WorkspaceId): Wing | undefined;
  load(id: WorkspaceId): Promise<Wing>;
  /** That of a step, before it is laid open: then it is on screen at once. */
  loadFor(recipe: Recipe, step: string): Promise<void>;
  /** Loads what is not loaded yet, for lists of everything. */
  loadAll(): Promise<void>;
}

export interface MessageService {
  toast(kind: Toast['kind'], text: string, action?: Toast['action']): void;
  dismiss(id: number): void;
  /** Shows whatever was thrown as a sentence. Cancelled work says nothing. */
  failed(error: unknown): void;
}

export interface DocumentService {
  undo(): void;
  redo(): void;
  /** Opens a step of the recipe: its items, its result. Undoable like every selection. */
  openStep(id: string): void;
  select(item: number | null): void;
  removeStep(id: string): void;
}

export interface WorkspaceService {
  /** Opens the last step of that kind, or starts one. */
  enter(workspace: WorkspaceId): Promise<void>;
  /** Goes on with the open step's result: opens the last step of that kind that does, or starts one. */
  goOn(workspace: WorkspaceId): Promise<void>;
  /** A step of that kind on a model, which does nothing yet and is not in the document. */
  stepOn(workspace: WorkspaceId, model: string): Promise<Step | undefined>;
  /** What a new step starts from: the open step's result, or its model where it does nothing yet. */
  openModel(): string | undefined;
}

export type ExportFormat = 'obj' | 'ply' | 'stl' | 'glb';

/** One line of the export dialog. */
export interface ExportChoice {
  readonly format: ExportFormat;
  readonly label: string;
  readonly keeps: string;
}

export interface FileService {
  /** The system's dialog; a mesh, a project or a recipe. */
  open(): Promise<void>;
  /** Files dropped on the window. Several: a mesh with what it refers to. */
  openFiles(files: readonly File[]): Promise<void>;
  save(): Promise<void>;
  saveAs(): Promise<void>;
  readonly exportChoices: readonly ExportChoice[];
  /** Models that the open step leaves, where it leaves several. Reads signals. */
  exportModels(): readonly Model[];
  /** @param number  of several models; the one on screen where left out */
  exportModel(format: ExportFormat, number?: number): Promise<void>;
  /** What the open workspace writes beside models. Reads signals. */
  exportGroup(): ExportGroup | undefined;
  exportOf(group: ExportGroup, format: string, option: boolean): Promise<void>;
  screenshot(): Promise<void>;
}

export interface GalleryEntry {
  readonly name: string;
  readonly title: string;
  readonly licence: string;
  readonly vertices: number;
  /** Address of the picture. */
  readonly thumbnail: string;
  /** It says where its scalp is. */
  readonly scalp?: boolean;
  /** It is made to be put on. */
  readonly worn?: boolean;
  /** No file holds its model: it is made here when it is opened. */
  readonly made?: boolean;
  /** Present for a finished example instead of a bare model. */
  readonly recipe?: string;
  /** Of a finished example: where it is worked on. */
  readonly workspace?: WorkspaceId;
}

export interface GalleryService {
  readonly entries: ReadonlySignal<readonly GalleryEntry[]>;
  open(entry: GalleryEntry): Promise<void>;
}

export interface RestorePoint {
  readonly id: string;
  /** ms since 1970. */
  readonly time: number;
  readonly title: string;
  readonly steps: number;
  readonly handles: number;
  /** `auto`: saved while working; `kept`: set aside because something else was opened. */
  readonly kind: 'auto' | 'kept';
  /** True for the document that is open here. */
  readonly current: boolean;
}

export interface AutosaveService {
  restorePoints(): Promise<readonly RestorePoint[]>;
  restore(id: string): Promise<void>;
}

/** A link, or why there is none. */
export type ShareResult =
  | { readonly kind: 'link'; readonly url: string; readonly fits: readonly ShareFit[] }
  | { readonly kind: 'needs-file'; readonly reason: string };

export interface ShareFit {
  readonly where: string;
  readonly limit: number;
  readonly fits: boolean;
}

export interface ShareService {
  link(): Promise<ShareResult>;
  /** Makes the link and copies it. */
  copy(): Promise<void>;
}

export interface Settings {
  readonly theme: 'dark' | 'light';
  /** Fingers navigate, only the pen paints. */
  readonly penOnly: boolean;
  /** Shortcuts of one letter (WCAG 2.1.4: may be switched off). */
  readonly singleKeys: boolean;
  /** Command id → shortcuts that replace the default ones. */
  readonly keys: Readonly<Record<string, readonly string[]>>;
}

export interface SettingsService {
  readonly values: ReadonlySignal<Settings>;
  update(change: Partial<Settings>): void;
}

export interface KeymapService {
  /** Shortcuts of a command as they are now; follows the settings. */
  keys(command: string): readonly string[];
  /** `Mod+Shift+Z` as this system writes it: `Ctrl+Shift+Z` or `⇧⌘Z`. */
  label(key: string): string;
  /** First shortcut as a label, `''` when there is none: for tooltips. */
  hint(command: string): string;
  /** The shortcut a key press stands for, `null` for a bare modifier. Used when remapping. */
  keyOf(event: KeyboardEvent): string | null;
  /**
   * @param command  the one that would take the key; left out: any holder will do
   * @returns the command that holds `key` now, whose shortcut it would take
   */
  ownerOf(key: string, command?: string): string | null;
  rebind(command: string, keys: readonly string[]): void;
  resetAll(): void;
}
