import { formatNumber, t } from '../../app/i18n';
import { Legend } from '../controls/legend';
import { useDress } from './use-dress';

/** What the colours of the garment mean. */
export function ClearanceLegend() {
  const clearance = useDress().state.clearance.value;
  if (!clearance) return null;
  const [low, high] = clearance.range.map((end) => formatNumber(Number(end.toPrecision(2)))) as [
    string,
    string,
  ];
  return <Legend title={t('ui.dress.clearance')} ends={[low, '0', high]} />;
}
