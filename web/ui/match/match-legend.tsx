import { t } from '../../app/i18n';
import { heatTop } from '../../app/match/result';
import { Legend } from '../controls/legend';
import { percent } from './percent';
import { useMatch } from './use-match';

/** What the colours of the skins mean, while they have any. */
export function MatchLegend() {
  const { state: own } = useMatch();
  const result = own.result.value;
  if (!result || !own.heat.value || own.growing.value) return null;
  const top = heatTop(result);
  return <Legend title={t('ui.match.heat')} ends={['0', percent(top / 2), percent(top)]} />;
}
