import { LENGTHS } from '../../app/hair/lengths';
import { t } from '../../app/i18n';
import { useApp } from '../context';
import { Legend } from '../controls/legend';

const percent = (factor: number): string => `${Math.round(100 * factor)} %`;

/** What the colours of painted lengths mean, while they are painted. */
export function LengthLegend() {
  if (useApp().state.tool.value !== 'paint-length') return null;
  const [low, high] = LENGTHS;
  return <Legend title={t('ui.hair.lengths')} ends={[percent(low), percent(1), percent(high)]} />;
}
