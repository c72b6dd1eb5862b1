import { t } from '../../app/i18n';
import { useApp } from '../context';
import { FigureList, milliseconds } from '../controls/figure-list';
import { useCurves } from './use-curves';

/** The model, and what its last pose took. */
export function CurvesFigures() {
  const { state } = useApp();
  const figures = useCurves().state.figures.value;
  const { vertices } = state.figures.value;
  return (
    <FigureList
      parts={[
        vertices !== null && t('ui.figure.vertices', { count: vertices }),
        figures !== null && t('ui.curves.figure.prepare', { ms: milliseconds(figures.prepare) }),
        figures !== null && t('ui.curves.figure.pose', { ms: milliseconds(figures.pose) }),
      ]}
    />
  );
}
