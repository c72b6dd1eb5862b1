import type { Command } from '../commands';
import { TOOLS } from '../state';
import type { CommandContext } from './context';

export const editCommands = ({ state, document, gestures }: CommandContext): Command[] => [
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
      if (state.hair.viewed.peek()) {
        state.hair.viewed.value = null;
        return;
      }
      if (gestures.cancel() || gestures.back()) return;
      if (state.merge.picked.value) {
        state.merge.picked.value = null;
        return;
      }
      const [home] = TOOLS[state.workspace.value];
      if (state.tool.value !== home) state.tool.value = home;
      else document.select(null);
    },
  },
];
