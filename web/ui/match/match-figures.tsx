import { t } from '../../app/i18n';
import { FigureList } from '../controls/figure-list';
import { useMatch } from './use-match';

/** What the skins are like, and what they took. */
export function MatchFigures() {
  const result = useMatch().state.result.value;
  return (
    <FigureList
      parts={[
        result !== null && t('ui.match.figure.skin', { count: result.models[0]!.positions.length / 3 }),
        result !== null && t('ui.match.figure.seconds', { seconds: Number(result.seconds.toFixed(1)) }),
      ]}
    />
  );
}
