import { BRUSH } from '../controls/brush';
import type { Face } from '../wings';
import './match.css';
import { MatchFigures } from './match-figures';
import { MatchLegend } from './match-legend';
import { MatchPanels } from './match-panels';
import { MatchStage } from './match-stage';

export const face: Face = {
  Panels: MatchPanels,
  Stage: MatchStage,
  stageClass: 'matching',
  Legend: MatchLegend,
  Figures: MatchFigures,
  extras: (tool) => [...(tool === 'match-mask' ? BRUSH : ['match.accept', 'match.remove', 'brush.mirror'])],
  viewCommands: ['match.look', 'match.heat', 'match.edges'],
};
