import type { Face } from '../wings';
import './curves.css';
import { CurvesFigures } from './curves-figures';
import { CurvesPanels } from './curves-panels';

const GIZMO = [
  'curves.gizmo.move',
  'curves.gizmo.turn',
  'curves.gizmo.twist',
  'curves.gizmo.scale',
  'curves.gizmo.end',
];

export const face: Face = {
  Panels: CurvesPanels,
  Figures: CurvesFigures,
  viewCommands: ['curves.crossings'],
  extras: (tool) => {
    if (tool === 'contours') return ['curves.contours.suggestive', 'curves.contours.beside'];
    if (tool === 'sketch-curve') return ['curves.surface', 'brush.mirror'];
    return tool === 'pose-curves' ? [...GIZMO, 'curves.reach'] : [];
  },
};
