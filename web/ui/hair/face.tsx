import { BRUSH } from '../controls/brush';
import type { Face } from '../wings';
import { HairFigures } from './hair-figures';
import { HairPanels } from './hair-panels';
import { LengthLegend } from './length-legend';

export const face: Face = {
  Panels: HairPanels,
  Legend: LengthLegend,
  Figures: HairFigures,
  extras(tool) {
    if (tool.startsWith('paint-')) return ['brush.mirror', ...BRUSH];
    if (tool === 'hint') return ['brush.mirror', 'hair.support-kind', 'hair.rebuild-support'];
    if (tool === 'ponytail') return ['brush.mirror', 'hair.rebuild-support', 'hair.done'];
    return ['brush.mirror'];
  },
};
