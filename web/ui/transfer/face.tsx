import { BRUSH } from '../controls/brush';
import type { Face } from '../wings';
import './transfer.css';
import { TransferFigures } from './transfer-figures';
import { TransferPanels } from './transfer-panels';
import { TransferStage } from './transfer-stage';

export const face: Face = {
  Panels: TransferPanels,
  Stage: TransferStage,
  stageClass: 'side-by-side',
  Figures: TransferFigures,
  extras: (tool) => ['transfer.next', ...(tool === 'paint-pair' ? ['transfer.clear', ...BRUSH] : [])],
  viewCommands: ['transfer.rest'],
};
