import type { MergeStep } from '../../recipe/recipe';
import type { ViewportPort } from '../../view/types';
import type { Paint, PaintHost, PaintScene } from '../brush-stroke';
import type { PaintVerb } from '../paint-tool';
import type { Loop } from './loops';
import type { MergeBoundary, MergeSide, Pin, SidePositions } from './pins';

/** What is painted for merging: the part's region, the feature in it, the region it goes to. */
export type Mark = 'source' | 'feature' | 'target';

/** One of the two models of the open merge step, as the tools of its pane read it. */
export interface MergeScene extends PaintScene {
  /** The committed step: what a gesture starts from. */
  readonly step: MergeStep;
  readonly positions: SidePositions;
  /** The openings of this side's model. */
  readonly loops: readonly Loop[];
  /** As shown: the step's own, or those the last merge found. */
  readonly pins: readonly Pin[];
  /** The step's boundaries with the pins above written into them. */
  readonly boundaries: readonly MergeBoundary[];
  /** Number of the selected pin. */
  readonly selected: number | null;
  mark(mark: Mark): Uint32Array;
}

export type MergeEditLabel = 'move-pin' | 'add-pin' | 'remove-pin';

export type PaneView = Pick<
  ViewportPort,
  'pick' | 'verticesWithin' | 'pixelSize' | 'setBrush' | 'project' | 'camera'
>;

/** What the tools of one pane need of the app. Tests use doubles. */
export interface MergeHost extends PaintHost {
  readonly side: MergeSide;
  readonly view: PaneView;
  /** `null` while a model is missing. */
  scene(): MergeScene | null;
  commitMark(mark: Mark, verb: PaintVerb, vertices: Uint32Array): void;
  showPaint(paint: Paint | null): void;
  preview(boundaries: readonly MergeBoundary[], selected: number | null): void;
  commit(label: MergeEditLabel, boundaries: readonly MergeBoundary[], selected: number | null): void;
  cancel(): void;
  select(pin: number | null): void;
  /** The opening under the pointer, or none. */
  hoverLoop(loop: Loop | null): void;
  /** This opening of this side shall be joined. */
  pickLoop(loop: Loop): void;
}
