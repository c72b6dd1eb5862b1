import type { Command } from '../commands';
import type { CommandContext } from './context';

export const editCommands = ({ state, document, gestures, wings }: CommandContext): Command[] => [
  {
    id: 'edit.undo',
    group: 'edit',
    title: 'command.edit.undo',
    icon: 'undo-2',
    keys: ['Mod+Z'],
    enabled: () => state.canUndo.value || state.previewing.value,
    run: () => {
      // What is under way goes first: the gesture, then what came before it.
      if (!gestures.cancel()) document.undo();
    },
  },
  {
    id: 'edit.redo',
    group: 'edit',
    title: 'command.edit.redo',
    icon: 'redo-2',
    keys: ['Mod+Shift+Z', 'Mod+Y'],
    enabled: () => state.canRedo.value,
    run: () => document.redo(),
  },
  {
    id: 'edit.cancel',
    group: 'edit',
    title: 'command.edit.cancel',
    icon: 'x',
    keys: ['Escape'],
    hidden: true,
    run: () => {
      if (state.viewing.peek()) {
        state.viewing.value = null;
        return;
      }
      if (gestures.cancel() || gestures.back()) return;
      const wing = wings.open.peek()?.wing;
      if (wing?.escape?.()) return;
      const home = wing?.tools[0];
      if (home !== undefined && state.tool.value !== home) state.tool.value = home;
      else document.select(null);
    },
  },
];
