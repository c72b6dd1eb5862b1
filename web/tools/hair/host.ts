import type { HairStep } from '../../recipe/recipe';
import type { ControlLinesPort } from '../../view/overlays/types';
import type { ViewportPort } from '../../view/types';
import type { Line } from '../stroke/polyline';
import type { SupportSurface } from '../stroke/support';
import type { CurveKind } from './style';

/** The open hair step and the head it works on, as tools read them. */
export interface HairScene {
  /** The committed step: what a gesture starts from. */
  readonly step: HairStep;
  /** Number of the selected primitive. */
  readonly selected: number | null;
  /** The head's extent from top to bottom, model units: all lengths of tools are parts of it. */
  readonly height: number;
  /** Whether edits happen on both sides of x = 0. */
  readonly mirror: boolean;
}

/** What an edit is called in the history. */
export type HairEditLabel =
  | 'add-stream'
  | 'add-parting'
  | 'add-ponytail'
  | 'ponytail-section'
  | 'ponytail-profile'
  | 'cut'
  | 'concatenate'
  | 'insert'
  | 'move-point'
  | 'tilt'
  | 'ponytail-back';

/** What a tool has to say about a stroke that came to nothing. */
export type HairRemark = 'too-short' | 'not-a-hint' | 'nothing-left' | 'tail-too-thin';

export interface HairEdit {
  readonly step: HairStep;
  /** The primitive selected afterwards. */
  readonly selected: number | null;
}

export type HairToolView = Pick<
  ViewportPort,
  'pick' | 'pointOnScreenPlane' | 'project' | 'pixelSize' | 'camera'
>;

/** What hair tools need of the app: one scene in, edits out. Tests use doubles. */
export interface HairHost {
  readonly view: HairToolView;
  readonly curves: Pick<ControlLinesPort, 'pickLine'>;
  /** `null` while no head is open. */
  scene(): HairScene | null;
  /** Shows an edit under way; nothing is history yet. */
  preview(edit: HairEdit): void;
  /** Makes an edit one step of undo. */
  commit(label: HairEditLabel, edit: HairEdit): void;
  /** Drops the preview: as if the gesture had never begun. */
  cancel(): void;
  select(primitive: number | null): void;
  /** The supporting surface of the selected curve, for the viewpoint it was built for. */
  support(): SupportSurface | null;
  /** Builds supporting surfaces for the view as it is now. */
  rebuildSupport(): void;
  /** Shows a stroke under way that is no edit yet; `null` ends it. */
  showStroke(stroke: { readonly line: Line; readonly kind: CurveKind } | null): void;
  /** A short friendly word about a gesture that did nothing. */
  say(remark: HairRemark): void;
  /** Whether the pointer is over something a drawing tool can start on. */
  aim(onHead: boolean): void;
}
