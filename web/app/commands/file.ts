import type { Command } from '../commands';
import type { DialogId } from '../state';
import type { CommandContext } from './context';

export function fileCommands({ state, files, viewport }: CommandContext): Command[] {
  const hasModel = () => state.model.value !== null;
  const dialog = (id: DialogId) => () => {
    state.dialog.value = id;
  };
  const group = 'file';
  return [
    {
      id: 'file.open',
      group,
      title: 'command.file.open',
      icon: 'folder-open',
      keys: ['Mod+O'],
      run: () => files.open(),
    },
    {
      id: 'file.gallery',
      group,
      title: 'command.file.gallery',
      icon: 'images',
      keys: ['Mod+G'],
      run: dialog('gallery'),
    },
    {
      id: 'file.save',
      group,
      title: 'command.file.save',
      icon: 'save',
      keys: ['Mod+S'],
      enabled: hasModel,
      run: () => files.save(),
    },
    {
      id: 'file.save-as',
      group,
      title: 'command.file.save-as',
      icon: 'save',
      keys: ['Mod+Shift+S'],
      enabled: hasModel,
      run: () => files.saveAs(),
    },
    {
      id: 'file.export',
      group,
      title: 'command.file.export',
      icon: 'download',
      keys: ['Mod+E'],
      enabled: hasModel,
      run: dialog('export'),
    },
    {
      id: 'file.screenshot',
      group,
      title: 'command.file.screenshot',
      icon: 'camera',
      enabled: () => hasModel() && viewport !== null,
      run: () => files.screenshot(),
    },
    {
      id: 'file.share',
      group,
      title: 'command.file.share',
      icon: 'share-2',
      enabled: hasModel,
      run: dialog('share'),
    },
    { id: 'file.restore', group, title: 'command.file.restore', icon: 'history', run: dialog('restore') },
  ];
}
