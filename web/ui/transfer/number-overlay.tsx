import { useEffect, useState } from 'preact/hooks';
import { listed } from '../../app/painted-regions';
import type { VertexSet } from '../../core/vertex-set';
import { centroid, gap, pointAt } from '../../tools/geometry';
import { isHidden } from '../../tools/sight';
import type { Vec3, ViewportPort } from '../../view/types';
import { useApp } from '../context';
import { useTransfer } from './use-transfer';

const RADIUS = 9;
/** Places on a handle that its number is tried at. */
const SAMPLES = 6;

interface Props {
  view: ViewportPort | null | undefined;
  /** Where the model's vertices are, and were at rest. */
  positions: Float64Array;
  rest: Float64Array;
  /** Of each handle, what it is on this model. */
  sets: readonly VertexSet[];
}

/** The number of each handle on a model. The pointer passes through. */
export function NumberOverlay({ view, positions, rest, sets }: Props) {
  const { state } = useApp();
  const { actions: transfer } = useTransfer();
  const [, redraw] = useState(0);
  useEffect(() => view?.onDraw(() => redraw((count) => count + 1)), [view]);
  const open = new Set(transfer.open());
  const selected = state.selection.value.item;
  if (!view) return null;
  return (
    <svg class="number-overlay" aria-hidden="true">
      {sets.map((set, index) => {
        const vertices = placesOn(set, rest);
        if (vertices.length === 0) return null;
        const { point, hidden } = placeOf(
          view,
          vertices.map((v) => pointAt(positions, v)),
        );
        const { x, y } = view.project(point);
        const marks = [open.has(index) && 'open', index === selected && 'selected', hidden && 'hidden'];
        return (
          <g
            key={index}
            class={['number-mark', ...marks.filter(Boolean)].join(' ')}
            transform={`translate(${x} ${y})`}
          >
            <circle r={RADIUS} />
            <text dy="4">{index + 1}</text>
          </g>
        );
      })}
    </svg>
  );
}

const places = new WeakMap<object, { readonly of: Float64Array; readonly vertices: readonly number[] }>();

/** Some vertices of a set, spread over it, those nearest to its middle at rest first. Sets never change in place. */
function placesOn(set: VertexSet, rest: Float64Array): readonly number[] {
  if (set === 'all') return [];
  const known = places.get(set);
  if (known?.of === rest) return known.vertices;
  const list = listed(set, rest.length / 3);
  const middle = centroid(rest, list);
  const stride = Math.ceil(list.length / SAMPLES);
  const spread = [...list].filter((_, i) => i % stride === 0);
  const far = new Map(spread.map((v) => [v, gap(pointAt(rest, v), middle)]));
  const vertices = spread.sort((a, b) => far.get(a)! - far.get(b)!);
  places.set(set, { of: rest, vertices });
  return vertices;
}

/** Where a set's number is: at the first of its places that is in sight, else at the first. */
function placeOf(
  view: ViewportPort,
  points: readonly Vec3[],
): { readonly point: Vec3; readonly hidden: boolean } {
  const seen = points.find((point) => !isHidden(view, point));
  return { point: seen ?? points[0]!, hidden: seen === undefined };
}
