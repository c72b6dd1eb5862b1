import { BRUSH } from '../controls/brush';
import type { Face } from '../wings';
import { DeformPanels } from './deform-panels';
import { HeatLegend } from './heat-legend';

export const face: Face = {
  Panels: DeformPanels,
  Legend: HeatLegend,
  viewCommands: ['view.heat'],
  extras: (tool) =>
    tool.startsWith('paint-') ? ['brush.mirror', ...BRUSH] : ['gizmo.move', 'gizmo.rotate', 'gizmo.scale'],
};
