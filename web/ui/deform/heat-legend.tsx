import { t } from '../../app/i18n';
import { Legend } from '../controls/legend';
import { useDeform } from './use-deform';

const percent = (value: number): string => `${value < 0 ? '−' : '+'}${Math.round(Math.abs(value) * 100)} %`;

/** What the colours of the heat map mean, while it is shown. */
export function HeatLegend() {
  const { state: own } = useDeform();
  if (!own.heat.value) return null;
  const [low, high] = own.heatRange.value;
  return <Legend title={t('ui.heat')} ends={[percent(low), '0', percent(high)]} />;
}
