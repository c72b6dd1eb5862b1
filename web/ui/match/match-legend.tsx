import { t } from '../../app/i18n';
import { heatTop } from '../../app/match/result';
import { heatGradient } from '../../view/heat';
import { Legend } from '../controls/legend';
import { percent } from './percent';
import { useMatch } from './use-match';

/** The heat map's warm half: distances have no other side. */
const COLOURS = heatGradient(21).slice(10);

/** What the colours of the skins mean, while they have any. */
export function MatchLegend() {
  const { state: own } = useMatch();
  const result = own.result.value;
  if (!result || !own.heat.value || own.growing.value) return null;
  const top = heatTop(result);
  return <Legend title={t('ui.match.heat')} ends={['0', percent(top / 2), percent(top)]} colours={COLOURS} />;
}
