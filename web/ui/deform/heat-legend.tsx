import { t } from '../../app/i18n';
import { heatGradient } from '../../view/heat';
import { useApp } from '../context';

const percent = (value: number): string => `${value < 0 ? '−' : '+'}${Math.round(Math.abs(value) * 100)} %`;

export function HeatLegend() {
  const [low, high] = useApp().state.heatRange.value;
  return (
    <figure class="legend">
      <figcaption>{t('ui.heat')}</figcaption>
      <div
        class="legend-bar"
        style={{ background: `linear-gradient(to right, ${heatGradient().join(', ')})` }}
      />
      <div class="legend-ends">
        <span>{percent(low)}</span>
        <span>0</span>
        <span>{percent(high)}</span>
      </div>
    </figure>
  );
}
