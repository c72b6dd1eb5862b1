// The app as components see it: signals to read (`state`), services to call. `main.ts` builds it;
// tests and components under test may hand in doubles.
//
// Command ids (commands/*.ts): file.open file.gallery file.save file.save-as file.export file.screenshot
// file.share file.restore · edit.undo edit.redo · tool.select tool.paint-roi tool.paint-handle
// tool.point-handle brush.larger brush.smaller brush.erase brush.mirror roi.everything roi.clear ·
// handle.new handle.delete handle.hide handle.reset handle.deselect handle.next handle.previous step.apply ·
// gizmo.move gizmo.rotate gizmo.scale · view.fit view.front view.back view.left view.right view.top view.bottom
// view.home view.projection view.wireframe view.smooth view.grid view.heat view.theme ·
// help.palette help.shortcuts help.settings

import type { ReadonlySignal } from '@preact/signals';
import type { VertexSet } from '../core/vertex-set';
import type { StrandFormat } from '../io/strands/options';
import type { RegionMaps } from '../kernel/contract/merge';
import type { DeformHandle, DeformStep, HairStep, MergeStep, ModelRef } from '../recipe/recipe';
import type { PrimitivePatch } from '../tools/hair/style';
import type { Mark } from '../tools/merge/host';
import type { MergeSide, Pin } from '../tools/merge/pins';
import type { ViewportPort } from '../view/types';
import type { Commands } from './commands';
import type { Panes } from './merge/panes';
import type { OptimalBoundary } from './merge/steps';
import type { State, Toast, WorkspaceId } from './state';

export interface App {
  readonly state: State;
  readonly commands: Commands;
  readonly keymap: KeymapService;
  readonly document: DocumentService;
  readonly deform: DeformService;
  readonly hair: HairService;
  readonly merge: MergeService;
  readonly workspaces: WorkspaceService;
  readonly files: FileService;
  readonly autosave: AutosaveService;
  readonly share: ShareService;
  readonly settings: SettingsService;
  readonly gallery: GalleryService;
  readonly messages: MessageService;
  /** `null` where WebGL 2 is missing: panels, files and links still work. */
  readonly viewport: ViewportPort | null;
  /** Those of the two models being merged; `null` until they are first needed. */
  readonly panes: ReadonlySignal<Panes | null>;
  /** Loads the newer version that `state.updateReady` announced. */
  reload(): void;
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
  /** Opens a step of the recipe: its handles, its result. Undoable like every selection. */
  openStep(id: string): void;
  select(handle: number | null): void;
  removeStep(id: string): void;
}

/** Angles in degrees, about the handle's rest centroid: x first, then y, then z, about the model's axes. */
export interface HandlePose {
  readonly translation: readonly [number, number, number];
  readonly rotation: readonly [number, number, number];
  readonly scale: readonly [number, number, number];
}

/** Edits of the open deform step. Each call is one step of undo, except previews. */
export interface DeformService {
  setRoi(roi: VertexSet): void;
  setMethod(method: DeformStep['method']): void;
  setOptions(options: Partial<DeformStep['options']>): void;
  /** Name as shown: the handle's own, else `Handle 1` … */
  handleName(index: number): string;
  /** How many vertices it holds. */
  handleSize(handle: DeformHandle): number;
  rename(index: number, name: string): void;
  hide(index: number, hidden: boolean): void;
  remove(index: number): void;
  /** Back to rest. */
  reset(index: number): void;
  pose(index: number): HandlePose | undefined;
  /** Typed-in numbers; a part that is absent stays. `live` previews (slider, arrow held), then `finish`. */
  setPose(index: number, pose: Partial<HandlePose>, live?: boolean): void;
  finish(): void;
  cancel(): void;
  /** A new deform step on the result of the last one. */
  applyAndContinue(): void;
}

/** Fields of a hair step beside its curves; a group is patched field by field, `undefined` takes a field away. */
export type HairPatch = {
  readonly [G in 'grid' | 'strands' | 'length' | 'detail' | 'material']?: {
    readonly [F in keyof HairStep[G]]?: HairStep[G][F] | undefined;
  };
} & { readonly volume?: number | undefined };

/** Edits of the open hair step. Each call is one step of undo, except previews; primitives by their number. */
export interface HairService {
  select(primitive: number | null): void;
  /** Name as shown: its own, else `Stream 1` … */
  primitiveName(index: number): string;
  rename(index: number, name: string): void;
  hide(index: number, hidden: boolean): void;
  remove(index: number): void;
  duplicate(index: number): void;
  /** Options of a primitive. `live` previews (slider held), then `finish`. */
  setPrimitive(index: number, patch: PrimitivePatch, live?: boolean): void;
  /** Count, length, detail, look … `live` previews, then `finish`. */
  update(patch: HairPatch, live?: boolean): void;
  finish(): void;
  cancel(): void;
  newSeed(): void;
  /** Puts another built-in head under the style; strokes move along with the scalp. */
  setHead(builtin: string): Promise<void>;
  /** How many vertices hair grows from; 0 where a scalp is still to be painted. */
  scalpSize(): number;
  /** Head height of the open step, model units; 1 while none is open. Default lengths are parts of it. */
  headHeight(): number;
  rebuildSupport(): void;
}

/** Edits of the open merge step. Each call is one step of undo, except previews and the choice of a part. */
export interface MergeService {
  /** Asks for the part to add to a model or a step's result. */
  start(target: string): Promise<void>;
  /** Asks for another part. */
  changePart(): Promise<void>;
  cancelChoosing(): Promise<void>;
  /** The part that was asked for; the merge step begins, or goes on with this part. */
  choosePart(name: string, ref: ModelRef): void;
  /** How many vertices are marked. */
  markSize(mark: Mark): number;
  clearMark(mark: Mark): void;
  /** Finds where the models meet, as far as that is not said yet, and merges them. */
  merge(): Promise<void>;
  /** Joins the models along the edges of the marks instead of a line that is sought. */
  cutAlongMarks(): Promise<void>;
  removePair(index: number): void;
  /** As shown: the step's own, or those the last merge found. */
  pins(): readonly Pin[];
  removePin(number: number): void;
  setMode(mode: MergeStep['mode']): void;
  /** How far from the seam a part merged in place gives way, as a part of the loops' length. */
  reach(): number;
  setReach(share: number, live?: boolean): void;
  /** Where the part stands in the target's space, for merging in place; about its middle. */
  pose(): HandlePose;
  setPose(pose: Partial<HandlePose>, live?: boolean): void;
  /** `live` previews (slider held), then `finish`. */
  setSmoothing(rounds: number, live?: boolean): void;
  /** Widths of the overlapped strips as parts of the loops' lengths; `null`: none. */
  setTransition(shares: Readonly<Record<MergeSide, number>> | null, live?: boolean): void;
  transitionShares(): Readonly<Record<MergeSide, number>>;
  /** The two plane maps, the part's not placed yet; `null` where the marks allow none. */
  maps(): Promise<RegionMaps | null>;
  /** How the part's map lies on the target's; `undefined`: found again. */
  setPlacement(placement: OptimalBoundary['placement']): void;
  finish(): void;
  cancel(): void;
}

export interface WorkspaceService {
  /** Opens the last step of that kind, or starts one. */
  enter(workspace: WorkspaceId): Promise<void>;
  /** A hair step on the open model, whose scalp is to be painted. */
  growHere(): void;
}

export type ExportFormat = 'obj' | 'ply' | 'stl' | 'glb';

/** One line of the export dialog. */
export interface ExportChoice {
  readonly format: ExportFormat;
  readonly label: string;
  readonly keeps: string;
}

export interface StrandChoice {
  readonly format: StrandFormat;
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
  exportModel(format: ExportFormat): Promise<void>;
  readonly strandChoices: readonly StrandChoice[];
  /** The open hair step's strands, in centimetres. */
  exportStrands(format: StrandFormat, guidesOnly: boolean): Promise<void>;
  screenshot(): Promise<void>;
}

export interface GalleryEntry {
  readonly name: string;
  readonly title: string;
  readonly licence: string;
  readonly vertices: number;
  /** Address of the picture. */
  readonly thumbnail: string;
  /** A head that hair grows on. */
  readonly scalp?: boolean;
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
