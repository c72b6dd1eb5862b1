import type { MarkerPlace, MatchStep } from '../../recipe/steps/match';
import type { Vec3, ViewportPort } from '../../view/types';
import type { PaintHost, PaintScene } from '../brush-stroke';
import type { EdgeGraph } from '../edge-graph';
import type { PaintVerb } from '../paint-tool';
import type { Line } from '../stroke/polyline';
import type { Spot, Surface } from './places';

/** One of the models that are matched, as the tools on it read it. */
export interface MatchScene extends PaintScene {
  /** The committed step: what a gesture starts from. */
  readonly step: MatchStep;
  /** Number of the model. */
  readonly at: number;
  readonly surface: Surface;
  /** Number of the selected marker, of the selected curve. */
  readonly marker: number | null;
  readonly curve: number | null;
  /** Rows of vertices along the model's picked edges, and the number of the selected one. */
  readonly sharp: readonly (readonly number[])[];
  readonly sharpRow: number | null;
  /** Its edges, worked out when they are first asked for. */
  edges(): EdgeGraph;
  /** Where the selected marker may belong on this model. */
  readonly ghost: Spot | null;
  /** Vertices of the model that are ignored. */
  readonly ignored: Uint32Array;
}

export type MarkVerb = 'place' | 'move';

/** What the tools of one model need of the app. Tests use doubles. */
export interface MatchHost extends PaintHost {
  readonly view: Pick<
    ViewportPort,
    'pick' | 'project' | 'camera' | 'verticesWithin' | 'pixelSize' | 'setBrush' | 'pointOnScreenPlane'
  >;
  /** `null` while there is no model, or nothing to be marked. */
  scene(): MatchScene | null;
  /** Shows a marker there while the pointer has it. */
  previewMarker(marker: number, spot: Spot): void;
  commitMarker(verb: MarkVerb, marker: number, spot: Spot): void;
  pickMarker(marker: number): void;
  /** Shows a line under way; `null` ends it. */
  showLine(line: Line | null): void;
  commitCurve(curve: number, row: MarkerPlace[]): void;
  /** @param row  number of a picked edge, or of a new one. @param vertices  along it; none: it is left */
  commitSharp(row: number, vertices: readonly number[]): void;
  commitMask(verb: PaintVerb, vertices: Uint32Array): void;
  /** A line is too short to be one. */
  tooShort(): void;
  /** Drops the preview: as if the gesture had never begun. */
  cancel(): void;
}

/** CSS pixels within which a marker is taken hold of. */
const REACH = { mouse: 12, pen: 16, touch: 22 } as const;

/** The nearest of some points to a place on the screen, by number, where one is in reach. */
export function pointNear(
  view: Pick<ViewportPort, 'project'>,
  points: readonly (Vec3 | null)[],
  { x, y, pointerType }: { readonly x: number; readonly y: number; readonly pointerType: keyof typeof REACH },
): number | null {
  let found: number | null = null;
  let nearest: number = REACH[pointerType];
  for (const [at, point] of points.entries()) {
    if (!point) continue;
    const seen = view.project(point);
    const off = seen.behind ? Number.POSITIVE_INFINITY : Math.hypot(seen.x - x, seen.y - y);
    if (off > nearest) continue;
    nearest = off;
    found = at;
  }
  return found;
}
