import { t } from '../../app/i18n';
import { useApp } from '../context';
import { Legend } from '../controls/legend';

const percent = (value: number): string => `${value < 0 ? '−' : '+'}${Math.round(Math.abs(value) * 100)} %`;

export function HeatLegend() {
  const [low, high] = useApp().state.heatRange.value;
  return <Legend title={t('ui.heat')} ends={[percent(low), '0', percent(high)]} />;
}
