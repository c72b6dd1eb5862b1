import { t } from '../../app/i18n';
import { FigureList, milliseconds } from '../controls/figure-list';
import { useHair } from './use-hair';

/** What the last hair took. */
export function HairFigures() {
  const figures = useHair().state.figures.value;
  if (!figures) return null;
  const { strands, constraints, grid, update, field, grow, stroke } = figures;
  return (
    <FigureList
      parts={[
        t('ui.hair.figure.strands', { count: strands }),
        t('ui.hair.figure.constraints', { count: constraints }),
        t('ui.hair.figure.grid', { size: grid.join(' × ') }),
        t('ui.hair.figure.update', { ms: milliseconds(update) }),
        t('ui.hair.figure.field', { ms: milliseconds(field) }),
        t('ui.hair.figure.grow', { ms: milliseconds(grow) }),
        stroke !== null && t('ui.hair.figure.stroke', { ms: Math.round(stroke) }),
      ]}
    />
  );
}
