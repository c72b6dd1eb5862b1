// What the curves workspace knows beside the document, as signals. No behaviour here.

import { computed, type ReadonlySignal, signal } from '@preact/signals';
import type { PreparedCurves } from '../../kernel/contract/curve';
import { stepOf } from '../../recipe/edit';
import type { CurvesStep } from '../../recipe/recipe';
import type { CurveGizmo } from '../../tools/curves/gizmo-drag';
import { type Grip, gripOf } from '../../tools/curves/items';
import type { Mat4 } from '../../tools/geometry';
import type { Line } from '../../tools/stroke/polyline';
import type { Moving } from '../motion-sync';
import type { State } from '../state';
import { ContoursState } from './contours/state';

/** What came of the last pose. Times in milliseconds. */
export interface CurvesFigures {
  readonly prepare: number;
  readonly pose: number;
  /** Pairs of triangles that meet; `null` until they are counted. */
  readonly crossings: { readonly before: number; readonly after: number } | null;
}

export class CurvesState implements Moving {
  /** The open step while it is one of curves. */
  readonly step: ReadonlySignal<CurvesStep | undefined>;
  readonly grip: ReadonlySignal<Grip | null>;
  /** What dragging a control point does. */
  readonly gizmo = signal<CurveGizmo>('move');
  readBack: Moving['readBack'] = () => null;
  readonly movable = signal(false);
  /** What strokes become. */
  readonly kind = signal<'skeleton' | 'surface'>('skeleton');
  /** A drag moves the chain up to the point. */
  readonly reach = signal(false);
  /** How many neighbours on either side share a twist or a width. */
  readonly range = signal(0);
  /** Ids of curves that are not drawn. */
  readonly hidden = signal<ReadonlySet<string>>(new Set());
  /** The stroke under way, and the curve that it would become. */
  readonly stroke = signal<Line | null>(null);
  readonly foreseen = signal<Line | null>(null);
  /** Vertices that would follow the curve that a stroke under way would become. */
  readonly reached = signal<Uint32Array | null>(null);
  /** What is under the pointer. */
  readonly under = signal<Grip | null>(null);
  /** The drag under way has gone as far as the surface lets it. */
  readonly stopped = signal(false);
  /** What each curve takes over from its parent. */
  readonly parents = signal<readonly Mat4[]>([]);
  readonly prepared = signal<PreparedCurves | null>(null);
  readonly figures = signal<CurvesFigures | null>(null);
  /** Shows where the surface goes through itself. */
  readonly showCrossings = signal(false);
  /** Vertices of those faces. */
  readonly crossing = signal<Uint32Array | null>(null);
  /** The poses are played one after the other. */
  readonly playing = signal(false);
  /** Addresses of pictures of the poses, by `pictureKey`. */
  readonly posePictures = signal<ReadonlyMap<string, string>>(new Map());

  readonly contours: ContoursState;

  constructor(state: Pick<State, 'recipe' | 'selection' | 'tool' | 'workspace'>) {
    const { recipe, selection } = state;
    this.step = computed(() => stepOf(recipe.value, selection.value.step, 'curves'));
    this.grip = computed(() => {
      const grip = gripOf(selection.value.item);
      const curve = grip && this.step.value?.curves[grip.curve];
      return curve && (grip.point ?? 0) < curve.rest.length ? grip : null;
    });
    this.contours = new ContoursState(state, this.step);
  }
}
