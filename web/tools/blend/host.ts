import type { BlendStep } from '../../recipe/steps/blend';
import type { Paint, PaintHost, PaintScene } from '../brush-stroke';
import type { PaintVerb } from '../paint-tool';

/** The skin that is blended, as the tools that mark it read it. */
export interface BlendScene extends PaintScene {
  /** The committed step: what a gesture starts from. */
  readonly step: BlendStep;
  /** Vertices of the skin. */
  readonly count: number;
  /** Number of the selected part. */
  readonly selected: number | null;
}

/** A length between two vertices: along edges, or straight through. */
export interface Length {
  readonly from: number;
  readonly to: number;
  readonly straight: boolean;
}

/** What the tools need of the app. Tests use doubles. */
export interface BlendHost extends PaintHost {
  /** `null` while there is no skin. */
  scene(): BlendScene | null;
  showPaint(paint: Paint | null): void;
  /** @param part  its number; `null`: a new one */
  commit(verb: PaintVerb, part: number | null, vertices: Uint32Array): void;
  pick(part: number | null): void;
  /** The girth around the skin at a vertex is to be measured. */
  measure(vertex: number): void;
  /** The vertex where the length under way begins; `null`: none is begun. */
  lengthFrom(): number | null;
  beginLength(vertex: number): void;
  /** Shows what would be measured. */
  showLength(length: Length | null): void;
  measureLength(from: number, to: number, straight: boolean): void;
}
