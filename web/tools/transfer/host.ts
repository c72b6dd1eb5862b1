import type { DeformHandle, TransferStep } from '../../recipe/recipe';
import type { ViewportPort } from '../../view/types';
import type { Paint, PaintHost, PaintScene } from '../brush-stroke';
import type { PaintVerb } from '../paint-tool';

/** The model that gets the pose, as the tools that pair its parts read it. */
export interface TransferScene extends PaintScene {
  /** The committed step: what a gesture starts from. */
  readonly step: TransferStep;
  /** Vertices of the model. */
  readonly count: number;
  /** Handles of the pose; the step has a counterpart for each. */
  readonly handles: readonly DeformHandle[];
  /** Number of the selected handle. */
  readonly selected: number | null;
}

/** What the tools of the target need of the app. Tests use doubles. */
export interface TransferHost extends PaintHost {
  readonly view: Pick<ViewportPort, 'pick' | 'verticesWithin' | 'pixelSize' | 'setBrush'>;
  /** `null` while there is no model, or nothing to pair. */
  scene(): TransferScene | null;
  showPaint(paint: Paint | null): void;
  /** The counterpart of a handle is these vertices. */
  commit(verb: PaintVerb, handle: number, vertices: Uint32Array): void;
  /** A handle is pointed at, on either model. */
  pick(handle: number): void;
}
