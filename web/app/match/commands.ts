import { MAX_MATCHED } from '../../recipe/steps/match';
import type { Command } from '../commands';
import { pickTool } from '../commands/pick-tool';
import { selectedItem } from '../commands/selected-item';
import type { WingParts } from '../wing-parts';
import type { MatchActions } from './actions';
import { LOOKS, type MatchState } from './state';

export const TOOLS = ['match-marker', 'match-turn', 'match-curve', 'match-sharp', 'match-mask'] as const;

type Context = Pick<WingParts, 'state' | 'document' | 'gestures'>;

export function matchCommands(context: Context, own: MatchState, match: MatchActions): Command[] {
  const { state, document } = context;
  const workspace = 'match';
  const group = 'match';
  const open = () => own.step.value !== undefined && !state.choosing.value;
  const { selected, onSelected, stepped } = selectedItem(state);
  const markers = () => own.step.value?.markers.length ?? 0;
  const has = () => open() && own.result.value !== null;
  const tool = pickTool<(typeof TOOLS)[number]>(workspace, context);
  return [
    tool('match-marker', 'map-pin', ['V']),
    tool('match-turn', 'mouse-pointer-2', ['H']),
    tool('match-curve', 'spline', ['C']),
    tool('match-sharp', 'triangle-right', ['S']),
    tool('match-mask', 'paintbrush', ['B']),
    {
      id: 'match.run',
      group,
      workspace,
      title: 'command.match.run',
      icon: 'git-compare-arrows',
      keys: ['Mod+Enter'],
      enabled: () => open() && match.canRun(),
      run: () => match.run(),
    },
    {
      id: 'match.again',
      group,
      workspace,
      title: 'command.match.again',
      icon: 'refresh-cw',
      hidden: true,
      enabled: () => open() && match.canRun(),
      run: () => match.run(),
    },
    {
      id: 'match.accept',
      group,
      workspace,
      title: 'command.match.accept',
      icon: 'check',
      keys: ['Enter'],
      enabled: () => open() && match.marking.next() !== undefined,
      run: () => match.marking.accept(),
    },
    {
      id: 'match.forward',
      group,
      workspace,
      title: 'command.match.forward',
      keys: ['.'],
      enabled: () => open() && markers() > 0,
      run: () => match.pick(stepped(1, markers())),
    },
    {
      id: 'match.backward',
      group,
      workspace,
      title: 'command.match.backward',
      keys: [','],
      enabled: () => open() && markers() > 0,
      run: () => match.pick(stepped(-1, markers())),
    },
    {
      id: 'match.remove',
      group,
      workspace,
      title: 'command.match.remove',
      icon: 'trash-2',
      keys: ['Delete', 'Backspace'],
      enabled: () => open() && selected(),
      run: onSelected((item) => match.marking.remove(item)),
    },
    {
      id: 'match.remove-all',
      group,
      workspace,
      title: 'command.match.remove-all',
      icon: 'trash-2',
      enabled: () => open() && markers() > 0,
      run: () => match.marking.removeAll(),
    },
    {
      id: 'match.deselect',
      group,
      workspace,
      title: 'command.match.deselect',
      enabled: selected,
      run: () => document.select(null),
    },
    {
      id: 'match.add',
      group,
      workspace,
      title: 'command.match.add',
      icon: 'plus',
      enabled: () => open() && (own.step.value?.models.length ?? 0) < MAX_MATCHED,
      run: () => match.models.add(),
    },
    {
      id: 'match.look',
      group,
      workspace,
      title: 'command.match.look',
      icon: 'layers',
      keys: ['T'],
      enabled: has,
      run: () => {
        const now = LOOKS.indexOf(own.lookOf(0));
        match.lookAll(LOOKS[(now + 1) % LOOKS.length]!);
      },
    },
    {
      id: 'match.heat',
      group,
      workspace,
      title: 'command.match.heat',
      icon: 'thermometer',
      keys: ['E'],
      enabled: has,
      checked: () => own.heat.value,
      run: () => {
        own.heat.value = !own.heat.value;
      },
    },
    {
      id: 'match.edges',
      group,
      workspace,
      title: 'command.match.edges',
      icon: 'shapes',
      keys: ['W'],
      enabled: has,
      checked: () => own.edges.value,
      run: () => {
        own.edges.value = !own.edges.value;
      },
    },
  ];
}
