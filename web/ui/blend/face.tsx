import { BRUSH } from '../controls/brush';
import type { Face } from '../wings';
import './blend.css';
import { BlendFigures } from './blend-figures';
import { BlendPanels } from './blend-panels';

export const face: Face = {
  Panels: BlendPanels,
  Figures: BlendFigures,
  extras: (tool) => (tool === 'paint-part' ? ['blend.new-part', ...BRUSH] : []),
};
