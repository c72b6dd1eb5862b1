import type { CommandGroup } from '../../app/commands';
import { t } from '../../app/i18n';
import { useApp } from '../context';
import { Dialog } from '../controls/dialog';

/** Around the open wing's own. */
const FIRST: readonly CommandGroup[] = ['tool'];
const LAST: readonly CommandGroup[] = ['edit', 'view', 'file', 'help'];

/** The keyboard map, made from the command registry. */
export function HelpDialog({ onClose }: { onClose: () => void }) {
  const { commands, keymap, wings } = useApp();
  const own = wings.open.value?.wing.group;
  const groups = [...FIRST, ...(own ? [own] : []), ...LAST];
  return (
    <Dialog wide title={t('ui.help')} closeLabel={t('ui.close')} onClose={onClose}>
      <section class="help-pointer">
        {(['orbit', 'pan', 'zoom', 'paint', 'erase', 'touch'] as const).map((gesture) => (
          <p key={gesture}>{t(`ui.help.${gesture}`)}</p>
        ))}
      </section>
      <div class="help-groups">
        {groups.map((group) => (
          <section key={group}>
            <h3>{t(`ui.group.${group}`)}</h3>
            <dl>
              {commands.all
                .filter(
                  (command) =>
                    command.group === group &&
                    commands.isAtHand(command) &&
                    keymap.keys(command.id).length > 0,
                )
                .map((command) => (
                  <div key={command.id}>
                    <dt>{t(command.title)}</dt>
                    <dd>
                      {keymap.keys(command.id).map((key) => (
                        <kbd key={key}>{keymap.label(key)}</kbd>
                      ))}
                    </dd>
                  </div>
                ))}
            </dl>
          </section>
        ))}
      </div>
      <p class="muted">
        {t('ui.help.version', { version: __VERSION__ })} ·{' '}
        <a href="licences.txt" target="_blank" rel="noreferrer">
          {t('ui.help.licences')}
        </a>
      </p>
    </Dialog>
  );
}
