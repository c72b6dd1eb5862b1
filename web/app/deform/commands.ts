import type { GizmoMode } from '../../view/types';
import type { Command } from '../commands';
import { pickTool } from '../commands/pick-tool';
import { selectedItem } from '../commands/selected-item';
import type { MessageKey } from '../i18n';
import type { WingParts } from '../wing-parts';
import type { DeformService } from './api';
import type { DeformState } from './state';

export const TOOLS = ['select', 'paint-roi', 'paint-handle', 'point-handle'] as const;

type Context = Pick<WingParts, 'state' | 'document' | 'gestures'>;

export function deformCommands(context: Context, own: DeformState, deform: DeformService): Command[] {
  const { state, document } = context;
  const group = 'handle';
  const workspace = 'deform';
  const tool = pickTool<(typeof TOOLS)[number]>(workspace, context);
  const { selected, onSelected, stepped } = selectedItem(state);
  const count = () => own.step.value?.handles.length ?? 0;
  const next = (by: number) => () => document.select(stepped(by, count()));
  const gizmo = (mode: GizmoMode, name: 'move' | 'rotate' | 'scale', icon: string, key: string): Command => ({
    id: `gizmo.${name}`,
    group,
    workspace,
    title: `command.gizmo.${name}` satisfies MessageKey,
    icon,
    keys: [key],
    checked: () => own.gizmo.value === mode,
    run: () => {
      state.tool.value = 'select';
      own.gizmo.value = mode;
    },
  });
  return [
    tool('select', 'mouse-pointer-2', ['V']),
    tool('paint-roi', 'paintbrush', ['B']),
    tool('paint-handle', 'grab', ['H']),
    tool('point-handle', 'circle-dot', ['P']),
    {
      id: 'roi.everything',
      group: 'tool',
      workspace,
      title: 'command.roi.everything',
      icon: 'maximize',
      keys: ['A'],
      enabled: () => own.step.value !== undefined,
      run: () => deform.setRoi('all'),
    },
    {
      id: 'roi.clear',
      group: 'tool',
      workspace,
      title: 'command.roi.clear',

      enabled: () => own.step.value !== undefined,
      run: () => deform.setRoi([]),
    },
    {
      id: 'handle.new',
      group,
      workspace,
      title: 'command.handle.new',
      icon: 'plus',
      keys: ['N'],
      enabled: () => own.step.value !== undefined,
      run: () => {
        document.select(null);
        state.tool.value = 'paint-handle';
      },
    },
    {
      id: 'handle.delete',
      group,
      workspace,
      title: 'command.handle.delete',
      icon: 'trash-2',
      keys: ['Delete', 'Backspace'],
      enabled: selected,
      run: onSelected((handle) => deform.remove(handle)),
    },
    {
      id: 'handle.hide',
      group,
      workspace,
      title: 'command.handle.hide',
      icon: 'eye-off',
      enabled: selected,
      run: onSelected((handle) => deform.hide(handle, !own.step.value?.handles[handle]?.hidden)),
    },
    {
      id: 'handle.reset',
      group,
      workspace,
      title: 'command.handle.reset',
      icon: 'rotate-ccw',
      enabled: selected,
      run: onSelected((handle) => deform.reset(handle)),
    },
    {
      id: 'handle.deselect',
      group,
      workspace,
      title: 'command.handle.deselect',
      enabled: selected,
      run: () => document.select(null),
    },
    {
      id: 'handle.next',
      group,
      workspace,
      title: 'command.handle.next',
      keys: ['.'],
      enabled: () => count() > 0,
      run: next(1),
    },
    {
      id: 'handle.previous',
      group,
      workspace,
      title: 'command.handle.previous',
      keys: [','],
      enabled: () => count() > 0,
      run: next(-1),
    },
    gizmo('translate', 'move', 'move', 'W'),
    gizmo('rotate', 'rotate', 'rotate-3d', 'E'),
    gizmo('scale', 'scale', 'scale-3d', 'R'),
    {
      id: 'step.apply',
      group,
      workspace,
      title: 'command.step.apply',
      icon: 'check',
      keys: ['Mod+Enter'],
      enabled: () => count() > 0,
      run: () => deform.applyAndContinue(),
    },
    {
      id: 'view.heat',
      group: 'view',
      workspace,
      title: 'command.view.heat',
      icon: 'thermometer',
      keys: ['T'],
      checked: () => own.heat.value,
      run: () => {
        own.heat.value = !own.heat.value;
      },
    },
  ];
}
