import { useRef } from 'preact/hooks';
import { shortName } from '../../app/blend/matches';
import { t } from '../../app/i18n';
import { type Point, placeOf, sharesAt, type Three } from '../../tools/blend/weights';
import { Button } from '../controls/button';
import { SkinPicture } from './skin-picture';
import { useBlend } from './use-blend';

const WIDTH = 268;
const HEIGHT = 156;
const CORNERS: readonly [Point, Point, Point] = [
  { x: WIDTH / 2, y: 14 },
  { x: WIDTH / 2 + 82, y: HEIGHT - 14 },
  { x: WIDTH / 2 - 82, y: HEIGHT - 14 },
];
const PLACES = ['top', 'right', 'left'] as const;
const RADIUS = 9;
const OUTLINE = CORNERS.map(({ x, y }) => `${x},${y}`).join(' ');

/** Three models at the corners, and a dot between them. */
export function TriangleField() {
  const { state: own, actions: blend } = useBlend();
  const svg = useRef<SVGSVGElement>(null);
  const held = useRef(false);
  const corners = blend.corners();
  const step = own.step.value;
  if (!step || !corners) return null;
  const given = corners.map((name) => step.weights[name] ?? 0);
  const sum = given.reduce((all, weight) => all + weight, 0);
  const shares = given.map((weight) => (sum === 0 ? 1 / 3 : weight / sum)) as [number, number, number];
  const dot = placeOf(CORNERS, shares);
  const at = (event: PointerEvent): [number, number, number] => {
    const box = svg.current!.getBoundingClientRect();
    return sharesAt(CORNERS, {
      x: ((event.clientX - box.left) * WIDTH) / box.width,
      y: ((event.clientY - box.top) * HEIGHT) / box.height,
    });
  };
  const end = () => {
    if (held.current) blend.edits.finish();
    held.current = false;
  };
  const percent = (k: number) => Math.round(100 * given[k]!);
  return (
    <div class="triangle">
      <svg
        ref={svg}
        viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
        role="img"
        aria-label={t('ui.blend.triangle', {
          a: shortName(corners[0]),
          b: shortName(corners[1]),
          c: shortName(corners[2]),
          wa: percent(0),
          wb: percent(1),
          wc: percent(2),
        })}
        onPointerDown={(event) => {
          if (event.button !== 0) return;
          event.currentTarget.setPointerCapture(event.pointerId);
          held.current = true;
          blend.setShares(at(event), true);
        }}
        onPointerMove={(event) => {
          if (held.current) blend.setShares(at(event), true);
        }}
        onPointerUp={end}
        onPointerCancel={() => {
          if (held.current) blend.edits.cancel();
          held.current = false;
        }}
        onLostPointerCapture={end}
      >
        <polygon class="triangle-area" points={OUTLINE} />
        {CORNERS.map((corner, k) => (
          <line
            key={corners[k]}
            class="triangle-line"
            x1={corner.x}
            y1={corner.y}
            x2={dot.x}
            y2={dot.y}
            style={{ strokeOpacity: 0.15 + 0.75 * Math.min(1, Math.max(0, shares[k]!)) }}
          />
        ))}
        <circle class="triangle-dot" cx={dot.x} cy={dot.y} r={RADIUS} />
      </svg>
      {corners.map((name, k) => (
        <Corner key={PLACES[k]} at={k} name={name} corners={corners} />
      ))}
    </div>
  );
}

function Corner({ at, name, corners }: { at: number; name: string; corners: Three }) {
  const { actions: blend } = useBlend();
  const names = blend.names();
  return (
    <div class={`triangle-corner ${PLACES[at]}`}>
      <Button
        class="picture-button"
        iconOnly
        label={t('ui.blend.only', { name: shortName(name) })}
        onClick={() => blend.only(name)}
      >
        <SkinPicture name={name} />
      </Button>
      {names.length > corners.length ? (
        <select
          class="select"
          aria-label={t('ui.blend.corner')}
          value={name}
          onChange={(event) => blend.setCorner(at, event.currentTarget.value)}
        >
          {names.map((each) => (
            <option key={each} value={each}>
              {shortName(each)}
            </option>
          ))}
        </select>
      ) : (
        <span class="triangle-name">{shortName(name)}</span>
      )}
    </div>
  );
}
