import { primitivesOf } from '../../tools/hair/style';
import type { Command } from '../commands';
import type { HairShow } from '../hair/state';
import type { MessageKey } from '../i18n';
import type { CommandContext } from './context';
import { pickTool } from './pick-tool';

export function hairCommands(context: CommandContext): Command[] {
  const { state, document, hair, viewport } = context;
  const workspace = 'hair';
  const group = 'hair';
  const index = () => state.selection.value.handle;
  const selected = () => index() !== null;
  const primitives = () => (state.hairStep.value ? primitivesOf(state.hairStep.value) : []);
  const onSelected = (act: (index: number) => void) => () => {
    const at = index();
    if (at !== null) act(at);
  };
  const tool = pickTool(workspace, context, (id) => {
    // Whoever reaches for this one means to click a curve.
    if (id === 'hair-select') state.hair.show.value = { ...state.hair.show.peek(), curves: true };
  });
  const next = (by: number) => () => {
    const count = primitives().length;
    hair.select(((index() ?? (by > 0 ? -1 : 0)) + by + count) % count);
  };
  const show = (what: keyof HairShow, icon: string, keys: readonly string[] = []): Command => ({
    id: `hair.show-${what}`,
    group,
    workspace,
    title: `command.hair.show.${what}` satisfies MessageKey,
    icon,
    keys,
    checked: () => state.hair.show.value[what],
    run: () => {
      const shown = state.hair.show.value;
      state.hair.show.value = { ...shown, [what]: !shown[what] };
    },
  });
  return [
    tool('hair-select', 'mouse-pointer-2', ['V']),
    tool('stream', 'spline', ['S']),
    tool('hint', 'pencil', ['E']),
    tool('parting', 'split', ['P']),
    tool('ponytail', 'ribbon', ['T']),
    tool('paint-scalp', 'paintbrush', ['B']),
    tool('paint-length', 'scissors', ['L']),
    {
      id: 'hair.clear-lengths',
      group,
      workspace,
      title: 'command.hair.clear-lengths',
      icon: 'eraser',
      enabled: () => (state.hairStep.value?.length.map.length ?? 0) > 0,
      run: () => hair.update({ length: { map: [] } }),
    },
    {
      id: 'hair.delete',
      group,
      workspace,
      title: 'command.hair.delete',
      icon: 'trash-2',
      keys: ['Delete', 'Backspace'],
      enabled: selected,
      run: onSelected((at) => hair.remove(at)),
    },
    {
      id: 'hair.duplicate',
      group,
      workspace,
      title: 'command.hair.duplicate',
      icon: 'copy',
      keys: ['Mod+D'],
      enabled: selected,
      run: onSelected((at) => hair.duplicate(at)),
    },
    {
      id: 'hair.hide',
      group,
      workspace,
      title: 'command.hair.hide',
      icon: 'eye-off',
      keys: ['H'],
      enabled: selected,
      run: onSelected((at) => hair.hide(at, !primitives()[at]?.item.hidden)),
    },
    {
      id: 'hair.next',
      group,
      workspace,
      title: 'command.hair.next',
      keys: ['.'],
      enabled: () => primitives().length > 0,
      run: next(1),
    },
    {
      id: 'hair.previous',
      group,
      workspace,
      title: 'command.hair.previous',
      keys: [','],
      enabled: () => primitives().length > 0,
      run: next(-1),
    },
    {
      id: 'hair.done',
      group,
      workspace,
      title: 'command.hair.done',
      icon: 'check',
      keys: ['Enter'],
      enabled: selected,
      run: () => document.select(null),
    },
    {
      id: 'hair.rebuild-support',
      group,
      workspace,
      title: 'command.hair.rebuild-support',
      icon: 'rotate-ccw',
      keys: ['R'],
      enabled: () => viewport !== null && selected(),
      run: () => hair.rebuildSupport(),
    },
    {
      id: 'hair.support-kind',
      group,
      workspace,
      title: 'command.hair.support-kind',
      icon: 'layers',
      keys: ['U'],
      checked: () => state.hair.supportKind.value === 'ruled',
      run: () => {
        const kind = state.hair.supportKind;
        kind.value = kind.value === 'ruled' ? 'strip' : 'ruled';
      },
    },
    {
      id: 'hair.new-seed',
      group,
      workspace,
      title: 'command.hair.new-seed',
      icon: 'dices',
      enabled: () => state.hairStep.value !== undefined,
      run: () => hair.newSeed(),
    },
    {
      id: 'hair.end-viewing',
      group,
      title: 'command.hair.end-viewing',
      icon: 'x',
      enabled: () => state.hair.viewed.value !== null,
      run: () => {
        state.hair.viewed.value = null;
      },
    },
    show('hair', 'eye'),
    show('curves', 'spline', ['C']),
    show('support', 'layers'),
    show('field', 'move'),
    show('constraints', 'crosshair'),
    show('volume', 'box'),
  ];
}
