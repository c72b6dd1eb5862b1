import { t } from '../../app/i18n';
import { useApp } from '../context';
import { FigureList, milliseconds } from '../controls/figure-list';
import { useDress } from './use-dress';

/** The garment, and what the last fitting took. */
export function DressFigures() {
  const { vertices } = useApp().state.figures.value;
  const figures = useDress().state.figures.value;
  return (
    <FigureList
      parts={[
        vertices !== null && t('ui.figure.vertices', { count: vertices }),
        figures !== null && t('ui.dress.figure.prepare', { ms: milliseconds(figures.prepare) }),
        figures !== null && t('ui.dress.figure.dress', { ms: milliseconds(figures.dress) }),
      ]}
    />
  );
}
