import { t } from '../../app/i18n';
import { useApp } from '../context';
import { FigureList, milliseconds } from '../controls/figure-list';
import { useBlend } from './use-blend';

/** The skin, and what the last blend took. */
export function BlendFigures() {
  const { vertices } = useApp().state.figures.value;
  const figures = useBlend().state.figures.value;
  return (
    <FigureList
      parts={[
        vertices !== null && t('ui.figure.vertices', { count: vertices }),
        figures !== null && t('ui.blend.figure.prepare', { ms: milliseconds(figures.prepare) }),
        figures !== null && t('ui.blend.figure.blend', { ms: milliseconds(figures.blend) }),
      ]}
    />
  );
}
