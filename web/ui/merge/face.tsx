import { BRUSH } from '../controls/brush';
import type { Face } from '../wings';
import './merge.css';
import { MergePanels } from './merge-panels';
import { MergeStage } from './merge-stage';

export const face: Face = {
  Panels: MergePanels,
  Stage: MergeStage,
  stageClass: 'merging',
  extras: (tool) => (tool === 'merge-pins' ? ['merge.remove-pin'] : ['merge.through', ...BRUSH]),
};
