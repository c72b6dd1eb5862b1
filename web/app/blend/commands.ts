import type { Command } from '../commands';
import { pickTool } from '../commands/pick-tool';
import { selectedItem } from '../commands/selected-item';
import type { WingParts } from '../wing-parts';
import type { BlendActions } from './actions';
import type { BlendState } from './state';

export const TOOLS = ['pick-part', 'paint-part', 'measure-girth', 'measure-length'] as const;

type Context = Pick<WingParts, 'state' | 'document' | 'gestures' | 'workspaces'>;

export function blendCommands(context: Context, own: BlendState, blend: BlendActions): Command[] {
  const { state, document, workspaces } = context;
  const workspace = 'blend';
  const group = 'blend';
  const open = () => own.step.value !== undefined;
  const blended = () => open() && own.figures.value !== null;
  const { selected, onSelected } = selectedItem(state);
  const tool = pickTool<(typeof TOOLS)[number]>(workspace, context);
  return [
    tool('pick-part', 'mouse-pointer-2', ['V']),
    tool('paint-part', 'paintbrush', ['B']),
    tool('measure-girth', 'circle', ['T']),
    tool('measure-length', 'ruler', ['L']),
    {
      id: 'blend.new-part',
      group,
      workspace,
      title: 'command.blend.new-part',
      icon: 'plus',
      keys: ['N'],
      enabled: blended,
      run: () => {
        document.select(null);
        state.tool.value = 'paint-part';
      },
    },
    {
      id: 'blend.even',
      group,
      workspace,
      title: 'command.blend.even',
      icon: 'equal',
      keys: ['E'],
      enabled: open,
      run: () => blend.even(),
    },
    {
      id: 'blend.normalise',
      group,
      workspace,
      title: 'command.blend.normalise',
      icon: 'sigma',
      enabled: () => open() && blend.sum() !== 1,
      run: () => blend.normalise(),
    },
    {
      id: 'blend.presets',
      group,
      workspace,
      title: 'command.blend.presets',
      icon: 'person-standing',
      enabled: () => blended() && blend.measuring.isBody(),
      run: () => blend.measuring.addPresets(),
    },
    {
      id: 'blend.height',
      group,
      workspace,
      title: 'command.blend.height',
      icon: 'move-vertical',
      enabled: blended,
      run: () => blend.measuring.addHeight(),
    },
    {
      id: 'blend.keep',
      group,
      workspace,
      title: 'command.blend.keep',
      icon: 'check',
      enabled: () => blended() && blend.measuring.isWanted(),
      run: () => blend.keepFound(),
    },
    {
      id: 'blend.remove-part',
      group,
      workspace,
      title: 'command.blend.remove-part',
      icon: 'trash-2',
      keys: ['Delete', 'Backspace'],
      enabled: () => open() && selected(),
      run: onSelected((part) => blend.removePart(part)),
    },
    {
      id: 'blend.deselect',
      group,
      workspace,
      title: 'command.blend.deselect',
      enabled: selected,
      run: () => document.select(null),
    },
    {
      id: 'blend.deform',
      group,
      workspace,
      title: 'command.blend.deform',
      icon: 'move',
      enabled: blended,
      run: () => workspaces.goOn('deform'),
    },
    {
      id: 'blend.another',
      group,
      workspace,
      title: 'command.blend.another',
      icon: 'copy-plus',
      enabled: open,
      run: () => blend.start(),
    },
  ];
}
