import { useEffect, useRef, useState } from 'preact/hooks';
import { pointAt } from '../../tools/geometry';
import type { MergeSide, Pin } from '../../tools/merge/pins';
import { slot } from '../../tools/merge/pins';
import { isHidden } from '../../tools/sight';
import type { ViewportPort } from '../../view/types';
import { useApp } from '../context';
import { useMerge } from './use-merge';

const RADIUS = 10;

interface Place {
  readonly x: number;
  readonly y: number;
  readonly hidden: boolean;
}

/** Numbered pins on both models, and lines between partners. The pointer passes through: tools take hold of pins. */
export function PinOverlay() {
  const { state, panes } = useApp();
  const { state: own, actions: merge } = useMerge();
  const frame = useRef<SVGSVGElement>(null);
  const [, redraw] = useState(0);
  const [from, to] = panes.all.value;
  const views = from && to ? { source: from.viewport, target: to.viewport } : null;
  useEffect(() => {
    if (!views) return;
    const again = () => redraw((count) => count + 1);
    const stops = [views.source.onDraw(again), views.target.onDraw(again)];
    return () => {
      for (const stop of stops) stop();
    };
  }, [from, to]);
  const { source, target } = own.sides.value;
  const selected = state.selection.value.item;
  const boundaries = own.step.value?.boundaries ?? [];
  const half = (frame.current?.clientWidth ?? 0) / 2;
  const height = frame.current?.clientHeight ?? 0;
  const placed =
    views && source && target && half > 0
      ? merge.joins.pins().map((pin) => ({
          pin,
          ends: [
            placeOf(views.source, source.model.positions, pin, 'source', 0),
            placeOf(views.target, target.model.positions, pin, 'target', half),
          ] as const,
        }))
      : [];
  return (
    <svg ref={frame} class="pin-overlay" aria-hidden="true">
      <clipPath id="pin-panes">
        <rect width={2 * half} height={height} />
      </clipPath>
      <g clip-path="url(#pin-panes)">
        {placed.map(({ pin, ends: [a, b] }) => (
          <line
            key={pin.number}
            class={pin.number === selected ? 'tie selected' : 'tie'}
            x1={a.x}
            y1={a.y}
            x2={b.x}
            y2={b.y}
          />
        ))}
        {placed.flatMap(({ pin, ends }) =>
          ends.map(({ x, y, hidden }, side) => (
            <g
              key={`${pin.number} ${side}`}
              class={`pin-mark${pin.number === selected ? ' selected' : ''}${hidden ? ' hidden' : ''}${boundaries[pin.boundary]?.keys.length ? '' : ' found'}`}
              transform={`translate(${x} ${y})`}
            >
              <circle r={RADIUS} />
              <text dy="4">{pin.number + 1}</text>
            </g>
          )),
        )}
      </g>
    </svg>
  );
}

function placeOf(
  view: ViewportPort,
  positions: Float64Array,
  pin: Pin,
  side: MergeSide,
  left: number,
): Place {
  const point = pointAt(positions, pin.vertices[slot(side)]);
  const { x, y } = view.project(point);
  return { x: x + left, y, hidden: isHidden(view, point) };
}
