import type { Face } from '../wings';
import './dress.css';
import { ClearanceLegend } from './clearance-legend';
import { DressFigures } from './dress-figures';
import { DressPanels } from './dress-panels';
import { DressStage } from './dress-stage';

export const face: Face = {
  Panels: DressPanels,
  Stage: DressStage,
  stageClass: 'side-by-side dressing',
  Legend: ClearanceLegend,
  Figures: DressFigures,
  extras: () => [],
  viewCommands: ['dress.ghost', 'dress.heat'],
};
