import { useEffect, useState } from 'preact/hooks';
import { listed } from '../../app/painted-regions';
import type { VertexSet } from '../../core/vertex-set';
import { centroid, pointAt } from '../../tools/geometry';
import { isHidden } from '../../tools/sight';
import type { ViewportPort } from '../../view/types';
import { useApp } from '../context';
import { useTransfer } from './use-transfer';

const RADIUS = 9;

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
        const vertex = middle(set, rest);
        if (vertex === null) return null;
        const point = pointAt(positions, vertex);
        const { x, y, behind } = view.project(point);
        if (behind) return null;
        const marks = [
          open.has(index) && 'open',
          index === selected && 'selected',
          isHidden(view, point) && 'hidden',
        ];
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

const middles = new WeakMap<object, { readonly of: Float64Array; readonly vertex: number | null }>();

/** The vertex of a set that is nearest to its middle at rest. Sets never change in place, so it is sought once. */
function middle(set: VertexSet, rest: Float64Array): number | null {
  if (set === 'all') return null;
  const known = middles.get(set);
  if (known?.of === rest) return known.vertex;
  const vertices = listed(set, rest.length / 3);
  const [x, y, z] = centroid(rest, vertices);
  let vertex: number | null = null;
  let least = Number.POSITIVE_INFINITY;
  for (const v of vertices) {
    const [px, py, pz] = pointAt(rest, v);
    const gap = Math.hypot(px - x, py - y, pz - z);
    if (gap < least) [vertex, least] = [v, gap];
  }
  middles.set(set, { of: rest, vertex });
  return vertex;
}
