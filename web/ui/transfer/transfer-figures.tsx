import { t } from '../../app/i18n';
import { useApp } from '../context';
import { FigureList, milliseconds } from '../controls/figure-list';
import { useTransfer } from './use-transfer';

/** The model, and what the last transfer to it took. */
export function TransferFigures() {
  const { state } = useApp();
  const figures = useTransfer().state.figures.value;
  const { vertices } = state.figures.value;
  return (
    <FigureList
      parts={[
        vertices !== null && t('ui.figure.vertices', { count: vertices }),
        figures !== null && t('ui.transfer.figure.unknowns', { count: figures.unknowns }),
        figures !== null && t('ui.transfer.figure.prepare', { ms: milliseconds(figures.prepare) }),
        figures !== null && t('ui.transfer.figure.transfer', { ms: milliseconds(figures.transfer) }),
      ]}
    />
  );
}
