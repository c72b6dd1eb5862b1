import type { DisplayOptions, ViewPreset } from '../../view/types';
import type { Command } from '../commands';
import type { MessageKey } from '../i18n';
import type { CommandContext } from './context';

export function viewCommands({ state, settings, viewport, wings }: CommandContext): Command[] {
  const group = 'view';
  const shown = () => viewport !== null && state.model.value !== null;
  const preset = (name: ViewPreset, keys: readonly string[] = []): Command => ({
    id: `view.${name}`,
    group,
    title: `command.view.${name}` satisfies MessageKey,
    keys,
    enabled: shown,
    run: () => viewport?.setView(name),
  });
  const toggle = (
    name: 'wireframe' | 'smooth' | 'grid',
    icon: string,
    keys: readonly string[] = [],
  ): Command => ({
    id: `view.${name}`,
    group,
    title: `command.view.${name}` satisfies MessageKey,
    icon,
    keys,
    checked: () => state.display.value[name],
    run: () => {
      state.display.value = {
        ...state.display.value,
        [name]: !state.display.value[name],
      } satisfies DisplayOptions;
    },
  });
  return [
    {
      id: 'view.fit',
      group,
      title: 'command.view.fit',
      icon: 'focus',
      keys: ['F'],
      enabled: shown,
      run: () => {
        const wing = wings.open.peek()?.wing;
        viewport?.fit(wing?.selected?.());
        wing?.fit?.();
      },
    },
    preset('home', ['0']),
    preset('front', ['1']),
    preset('back', ['Shift+F1']),
    preset('right', ['3']),
    preset('left', ['Shift+F3']),
    preset('top', ['7']),
    preset('bottom', ['Shift+F7']),
    {
      id: 'view.projection',
      group,
      title: 'command.view.projection',
      icon: 'box',
      keys: ['5'],
      enabled: shown,
      run: () => {
        if (viewport) viewport.camera = { ...viewport.camera, orthographic: !viewport.camera.orthographic };
      },
    },
    toggle('wireframe', 'grid-3x3', ['Z']),
    toggle('smooth', 'circle'),
    toggle('grid', 'layers', ['G']),
    {
      id: 'view.theme',
      group,
      title: 'command.view.theme',
      icon: 'sun',
      run: () => settings.update({ theme: settings.values.value.theme === 'dark' ? 'light' : 'dark' }),
    },
  ];
}
