import { t } from '../../app/i18n';
import type { DisplayOptions } from '../../view/types';
import { useApp, useFace } from '../context';
import { Button } from '../controls/button';
import { CommandButton } from '../controls/command-button';
import { Menu } from '../controls/menu';

const SHADINGS: readonly DisplayOptions['shading'][] = [
  'clay',
  'matcap-clay',
  'matcap-pearl',
  'matcap-jade',
  'matcap-graphite',
  'vertex-colours',
];

/** Small controls that float over the viewport: how the model is shown. */
export function ViewBar() {
  const { state } = useApp();
  const own = useFace()?.viewCommands ?? [];
  const display = state.display.value;
  return (
    <div class="view-bar" role="toolbar" aria-label={t('ui.view')}>
      <Menu label={t('ui.shading')} icon="palette" iconOnly align="end">
        {SHADINGS.map((shading) => (
          <Button
            key={shading}
            role="menuitemradio"
            aria-checked={display.shading === shading}
            icon={display.shading === shading ? 'check' : 'circle'}
            label={t(`ui.shading.${shading}`)}
            onClick={() => {
              state.display.value = { ...display, shading };
            }}
          />
        ))}
        <hr />
        {['view.smooth', 'view.wireframe', 'view.grid', ...own].map((id) => (
          <CommandButton key={id} command={id} showShortcut />
        ))}
      </Menu>
      <CommandButton command="view.wireframe" iconOnly />
      {own.map((id) => (
        <CommandButton key={id} command={id} iconOnly />
      ))}
      <CommandButton command="view.fit" iconOnly />
      <Menu label={t('ui.cameras')} icon="camera" iconOnly align="end">
        {['home', 'front', 'back', 'left', 'right', 'top', 'bottom'].map((id) => (
          <CommandButton key={id} command={`view.${id}`} role="menuitem" showShortcut />
        ))}
        <hr />
        <CommandButton command="view.projection" showShortcut />
      </Menu>
    </div>
  );
}
