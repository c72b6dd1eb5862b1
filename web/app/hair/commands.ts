import { primitivesOf } from '../../tools/hair/style';
import type { Command } from '../commands';
import { pickTool } from '../commands/pick-tool';
import { selectedItem } from '../commands/selected-item';
import type { MessageKey } from '../i18n';
import type { WingParts } from '../wing-parts';
import type { HairService } from './api';
import type { HairShow, HairState } from './state';

export const TOOLS = [
  'hair-select',
  'stream',
  'hint',
  'parting',
  'ponytail',
  'paint-scalp',
  'paint-length',
] as const;

type Context = Pick<WingParts, 'state' | 'document' | 'gestures' | 'viewport'>;

export function hairCommands(context: Context, own: HairState, hair: HairService): Command[] {
  const { state, document, viewport } = context;
  const workspace = 'hair';
  const group = 'hair';
  const { selected, onSelected, stepped } = selectedItem(state);
  const primitives = () => (own.step.value ? primitivesOf(own.step.value) : []);
  const tool = pickTool<(typeof TOOLS)[number]>(workspace, context, (id) => {
    // Whoever reaches for this one means to click a curve.
    if (id === 'hair-select') own.show.value = { ...own.show.peek(), curves: true };
  });
  const next = (by: number) => () => hair.select(stepped(by, primitives().length));
  const show = (what: keyof HairShow, icon: string, keys: readonly string[] = []): Command => ({
    id: `hair.show-${what}`,
    group,
    workspace,
    title: `command.hair.show.${what}` satisfies MessageKey,
    icon,
    keys,
    checked: () => own.show.value[what],
    run: () => {
      const shown = own.show.value;
      own.show.value = { ...shown, [what]: !shown[what] };
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
      enabled: () => (own.step.value?.length.map.length ?? 0) > 0,
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
      checked: () => own.supportKind.value === 'ruled',
      run: () => {
        const kind = own.supportKind;
        kind.value = kind.value === 'ruled' ? 'strip' : 'ruled';
      },
    },
    {
      id: 'hair.new-seed',
      group,
      workspace,
      title: 'command.hair.new-seed',
      icon: 'dices',
      enabled: () => own.step.value !== undefined,
      run: () => hair.newSeed(),
    },
    {
      id: 'hair.end-viewing',
      group,
      title: 'command.hair.end-viewing',
      icon: 'x',
      enabled: () => state.viewing.value !== null,
      run: () => {
        state.viewing.value = null;
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
