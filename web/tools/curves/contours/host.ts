import type { PenHit, PenPart, PenPort } from '../../../view/overlays/types';
import type { Vec3, ViewportPort } from '../../../view/types';
import type { Line } from '../../stroke/polyline';
import type { PickedLine } from './picked';

export type ContoursView = Pick<
  ViewportPort,
  'camera' | 'pick' | 'project' | 'pixelSize' | 'pointOnScreenPlane'
>;

/** What the contour tool needs of the app. Tests use doubles. */
export interface ContoursHost {
  readonly view: ContoursView;
  readonly pen: Pick<PenPort, 'pickLines' | 'pickHold'>;
  /** The line in hand, how far it is pulled, and where it runs now. */
  held(): { readonly picked: PickedLine; readonly shift: Vec3; readonly line: Line } | null;
  /** The model's largest extent; 0 while there is none. */
  readonly size: number;
  /** Shows what is under the pointer: a line by its number, or a part of the line in hand. */
  hover(line: number | null, part: PenPart | null): void;
  pickUp(hit: PenHit): void;
  /** Shows the line in hand otherwise trimmed, or with another reach; `settle` ends that. */
  trim(span: readonly [number, number]): void;
  reach(radius: number): void;
  settle(): void;
  /** Shows the line in hand pulled from where it was; `release` keeps it. */
  pull(by: Vec3): void;
  release(): void;
  /** As if the gesture had never begun. */
  cancel(): void;
}
