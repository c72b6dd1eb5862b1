import { useEffect, useState } from 'preact/hooks';
import { isHidden } from '../../tools/sight';
import type { Vec3, ViewportPort } from '../../view/types';
import { useMatch } from './use-match';

const RADIUS = 9;

interface Props {
  view: ViewportPort | null | undefined;
  /** Number of the model. */
  at: number;
}

/** The numbers of a model's markers, the suggestion, the poor place that is looked at. The pointer passes through. */
export function MarkerOverlay({ view, at }: Props) {
  const { state: own, actions: match } = useMatch();
  const [, redraw] = useState(0);
  useEffect(() => view?.onDraw(() => redraw((count) => count + 1)), [view]);
  const step = own.step.value;
  if (!view || !step) return null;
  const selected = own.marker.value;
  const ghost = own.ghosts.value.find(({ model }) => model === at);
  return (
    <svg class="match-overlay" aria-hidden="true">
      <Poor view={view} at={at} />
      {match.marking.points(at).map((point, marker) => {
        if (!point) return null;
        const open = step.markers[marker]!.some((place) => place === null);
        const marks = [open && 'open', marker === selected && 'selected', isHidden(view, point) && 'hidden'];
        return <Numbered key={marker} view={view} point={point} text={marker + 1} marks={marks} />;
      })}
      {ghost && <Numbered view={view} point={ghost.spot.point} text={ghost.marker + 1} marks={['ghost']} />}
    </svg>
  );
}

interface NumberedProps {
  view: ViewportPort;
  point: Vec3;
  text: number;
  marks: readonly (string | false)[];
}

function Numbered({ view, point, text, marks }: NumberedProps) {
  const { x, y, behind } = view.project(point);
  if (behind) return null;
  return (
    <g class={['match-mark', ...marks.filter(Boolean)].join(' ')} transform={`translate(${x} ${y})`}>
      <circle r={RADIUS} />
      <text dy="4">{text}</text>
    </g>
  );
}

function Poor({ view, at }: { view: ViewportPort; at: number }) {
  const { state: own } = useMatch();
  const vertex = own.poor.value;
  const skin = own.skinOf(at);
  if (vertex === null || !skin) return null;
  const [x0, y0, z0] = skin.positions.subarray(3 * vertex, 3 * vertex + 3);
  const { x, y, behind } = view.project([x0!, y0!, z0!]);
  return behind ? null : <circle class="match-poor-place" cx={x} cy={y} r={22} />;
}
