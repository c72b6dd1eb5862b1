import type { Command } from '../commands';
import { pickTool } from '../commands/pick-tool';
import type { WingParts } from '../wing-parts';
import type { DressActions } from './actions';
import type { DressState } from './state';

export const TOOLS = ['view-dress'] as const;

type Context = Pick<WingParts, 'state' | 'gestures' | 'workspaces'>;

export function dressCommands(context: Context, own: DressState, dress: DressActions): Command[] {
  const { state, workspaces } = context;
  const workspace = 'dress';
  const group = 'dress';
  const open = () => own.step.value !== undefined && !state.choosing.value;
  const fitted = () => open() && own.figures.value !== null;
  return [
    pickTool<(typeof TOOLS)[number]>(workspace, context)('view-dress', 'mouse-pointer-2', ['V']),
    {
      id: 'dress.ghost',
      group,
      workspace,
      title: 'command.dress.ghost',
      icon: 'ghost',
      keys: ['O'],
      enabled: fitted,
      checked: () => own.ghost.value,
      run: () => {
        own.ghost.value = !own.ghost.value;
      },
    },
    {
      id: 'dress.heat',
      group,
      workspace,
      title: 'command.dress.heat',
      icon: 'thermometer',
      keys: ['T'],
      enabled: fitted,
      checked: () => own.heat.value,
      run: () => {
        own.heat.value = !own.heat.value;
      },
    },
    {
      id: 'dress.garment',
      group,
      workspace,
      title: 'command.dress.garment',
      icon: 'shirt',
      enabled: open,
      run: () => dress.choice.change(),
    },
    {
      id: 'dress.add',
      group,
      workspace,
      title: 'command.dress.add',
      icon: 'plus',
      keys: ['N'],
      enabled: open,
      run: () => dress.choice.start(),
    },
    {
      id: 'dress.another',
      group,
      workspace,
      title: 'command.dress.another',
      icon: 'copy-plus',
      enabled: () => open() && dress.canFitAnother,
      run: () => dress.another(),
    },
    {
      id: 'dress.deform',
      group,
      workspace,
      title: 'command.dress.deform',
      icon: 'move',
      enabled: fitted,
      run: () => workspaces.goOn('deform'),
    },
  ];
}
