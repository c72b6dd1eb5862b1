import type { DeformStep } from '../../recipe/recipe';
import type { MarkersPort } from '../../view/overlays/types';
import type { ViewportPort } from '../../view/types';
import type { PaintHost, PaintScene } from '../brush-stroke';

/** The open deform step and the shape it works on, as tools read them. */
export interface DeformScene extends PaintScene {
  /** The committed step: what a gesture starts from. */
  readonly step: DeformStep;
  /** Index of the selected handle. */
  readonly selected: number | null;
  /** The step's input, 3 per source vertex. */
  readonly rest: Float64Array;
  /** What is on screen, same vertices. */
  readonly posed: Float64Array;
}

/** What an edit is called in the history; `name` is the handle's. */
export type EditLabel =
  | 'paint-roi'
  | 'erase-roi'
  | 'fill-roi'
  | 'paint-handle'
  | 'erase-handle'
  | 'fill-handle'
  | 'add-point'
  | 'move-handle'
  | 'rotate-handle'
  | 'scale-handle';

export interface DeformEdit {
  readonly step: DeformStep;
  /** The handle selected afterwards. */
  readonly selected: number | null;
}

type ToolView = Pick<
  ViewportPort,
  'pick' | 'verticesWithin' | 'pointOnScreenPlane' | 'pixelSize' | 'setBrush'
>;

/** What deform tools need of the app: one scene in, edits out. Tests use doubles. */
export interface DeformHost extends PaintHost {
  readonly view: ToolView;
  readonly markers: Pick<MarkersPort, 'pickMarker'>;
  /** `null` while no model is open. */
  scene(): DeformScene | null;
  /** A name for the next new handle. */
  newName(step: DeformStep): string;
  /** Shows an edit under way; nothing is history yet. */
  preview(edit: DeformEdit): void;
  /** Makes an edit one step of undo. */
  commit(label: EditLabel, edit: DeformEdit): void;
  /** Drops the preview: as if the gesture had never begun. */
  cancel(): void;
  select(handle: number | null): void;
}

/** Ids of markers in the view: the handle's index. */
export const markerId = (handle: number): string => `handle:${handle}`;
export const handleOfMarker = (id: string): number => Number(id.slice('handle:'.length));
