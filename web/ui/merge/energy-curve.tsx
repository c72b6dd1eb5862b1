import { t } from '../../app/i18n';

const WIDTH = 264;
const HEIGHT = 56;
const MARGIN = 5;

/** The boundary's energy (Fu, Eq 3.1), round by round, as parts of that of the region's edge. */
export function EnergyCurve({ energy }: { energy: readonly number[] }) {
  const first = energy[0] || 1;
  const last = energy.at(-1)!;
  const places = energy.map((value, i) => [
    MARGIN + ((WIDTH - 2 * MARGIN) * i) / (energy.length - 1),
    HEIGHT - MARGIN - (HEIGHT - 2 * MARGIN) * Math.min(1, value / first),
  ]);
  const percent = Math.round((100 * last) / first);
  return (
    <figure class="energy">
      <figcaption>
        <span class="muted">{t('ui.merge.energy')}</span>
        <span>{t('ui.merge.energy.percent', { percent })}</span>
      </figcaption>
      <svg viewBox={`0 0 ${WIDTH} ${HEIGHT}`} role="img" aria-label={t('ui.merge.energy.help', { percent })}>
        <path class="ground" d={`M${MARGIN} ${HEIGHT - MARGIN}H${WIDTH - MARGIN}`} />
        <path class="curve" d={`M${places.map(([x, y]) => `${x} ${y}`).join('L')}`} />
        {places.map(([x, y], i) => (
          <circle key={i} cx={x} cy={y} r="2.5" />
        ))}
      </svg>
    </figure>
  );
}
