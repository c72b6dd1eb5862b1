import { LENGTHS } from '../../app/hair/lengths';
import { t } from '../../app/i18n';
import { Legend } from '../controls/legend';

const percent = (factor: number): string => `${Math.round(100 * factor)} %`;

export function LengthLegend() {
  const [low, high] = LENGTHS;
  return <Legend title={t('ui.hair.lengths')} ends={[percent(low), percent(1), percent(high)]} />;
}
