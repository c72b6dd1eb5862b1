import type { CurveGizmo } from '../../tools/curves/gizmo-drag';
import type { Command } from '../commands';
import { pickTool } from '../commands/pick-tool';
import type { MessageKey } from '../i18n';
import type { WingParts } from '../wing-parts';
import type { CurvesActions } from './actions';
import { contourCommands } from './contours/commands';
import type { Follow } from './follow';
import type { CurvesState } from './state';

export const TOOLS = ['pose-curves', 'sketch-curve', 'link-curves', 'contours'] as const;

type Context = Pick<WingParts, 'state' | 'document' | 'gestures'>;

export function curvesCommands(
  context: Context,
  own: CurvesState,
  curves: CurvesActions,
  follow: Follow,
): Command[] {
  const { state, document } = context;
  const workspace = 'curves';
  const group = 'curves';
  const open = () => own.step.value !== undefined;
  const selected = () => curves.curve() !== undefined;
  const onCurve = (act: (id: string) => void) => () => {
    const curve = curves.curve();
    if (curve) act(curve.id);
  };
  const tool = pickTool<(typeof TOOLS)[number]>(workspace, context);
  const gizmo = (mode: CurveGizmo, icon: string, key: string): Command => ({
    id: `curves.gizmo.${mode}`,
    group,
    workspace,
    title: `command.curves.gizmo.${mode}` satisfies MessageKey,
    icon,
    keys: [key],
    checked: () => own.gizmo.value === mode,
    run: () => {
      state.tool.value = 'pose-curves';
      own.gizmo.value = mode;
    },
  });
  return [
    tool('pose-curves', 'mouse-pointer-2', ['V']),
    tool('sketch-curve', 'pen-line', ['B']),
    tool('link-curves', 'link', ['L']),
    tool('contours', 'feather', ['N']),
    ...contourCommands(own, curves),
    gizmo('move', 'move', 'W'),
    gizmo('turn', 'rotate-3d', 'E'),
    gizmo('twist', 'ribbon', 'Q'),
    gizmo('scale', 'scale-3d', 'R'),
    gizmo('end', 'move-horizontal', 'T'),
    {
      id: 'curves.surface',
      group,
      workspace,
      title: 'command.curves.surface',
      icon: 'spline',
      keys: ['S'],
      enabled: open,
      checked: () => own.kind.value === 'surface',
      run: () => {
        own.kind.value = own.kind.peek() === 'surface' ? 'skeleton' : 'surface';
      },
    },
    {
      id: 'curves.propose',
      group,
      workspace,
      title: 'command.curves.propose',
      icon: 'sparkles',
      enabled: open,
      run: () => curves.propose(),
    },
    {
      id: 'curves.reach',
      group,
      workspace,
      title: 'command.curves.reach',
      icon: 'grab',
      keys: ['I'],
      enabled: open,
      checked: () => own.reach.value,
      run: () => {
        own.reach.value = !own.reach.peek();
      },
    },
    {
      id: 'curves.mirror',
      group,
      workspace,
      title: 'command.curves.mirror',
      icon: 'flip-horizontal-2',
      enabled: selected,
      run: () => curves.mirror(),
    },
    {
      id: 'curves.delete',
      group,
      workspace,
      title: 'command.curves.delete',
      icon: 'trash-2',
      keys: ['Delete', 'Backspace'],
      enabled: selected,
      run: onCurve((id) => curves.remove(id)),
    },
    {
      id: 'curves.reset',
      group,
      workspace,
      title: 'command.curves.reset',
      icon: 'rotate-ccw',
      enabled: selected,
      run: onCurve((id) => curves.reset(id)),
    },
    {
      id: 'curves.reset-all',
      group,
      workspace,
      title: 'command.curves.reset-all',
      icon: 'rotate-ccw',
      enabled: () => (own.step.value?.curves.length ?? 0) > 0,
      run: () => curves.reset(),
    },
    {
      id: 'curves.deselect',
      group,
      workspace,
      title: 'command.curves.deselect',
      enabled: selected,
      run: () => document.select(null),
    },
    {
      id: 'curves.add-pose',
      group,
      workspace,
      title: 'command.curves.add-pose',
      icon: 'plus',
      keys: ['K'],
      enabled: () => (own.step.value?.curves.length ?? 0) > 0,
      run: () => curves.addPose(),
    },
    {
      id: 'curves.play',
      group,
      workspace,
      title: 'command.curves.play',
      icon: 'play',
      keys: ['Space'],
      enabled: () => (own.step.value?.poses.length ?? 0) > 1,
      checked: () => own.playing.value,
      run: () => curves.player.toggle(),
    },
    {
      id: 'curves.crossings',
      group: 'view',
      workspace,
      title: 'command.curves.crossings',
      icon: 'triangle-alert',
      keys: ['C'],
      enabled: open,
      checked: () => own.showCrossings.value,
      run: () => follow.toggleCrossings(),
    },
  ];
}
