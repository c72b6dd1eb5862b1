import { useState } from 'preact/hooks';
import { t } from '../../app/i18n';
import { useAllWings, useApp } from '../context';
import { Button } from '../controls/button';
import { Dialog } from '../controls/dialog';
import { Segments, Switch } from '../controls/fields';

export function SettingsDialog({ onClose }: { onClose: () => void }) {
  const { settings, commands, keymap } = useApp();
  useAllWings();
  const values = settings.values.value;
  return (
    <Dialog title={t('ui.settings')} closeLabel={t('ui.close')} onClose={onClose}>
      <div class="field">
        <span class="label">{t('ui.settings.theme')}</span>
        <Segments
          label={t('ui.settings.theme')}
          value={values.theme}
          options={[
            { value: 'dark' as const, label: t('ui.settings.dark'), icon: 'moon' },
            { value: 'light' as const, label: t('ui.settings.light'), icon: 'sun' },
          ]}
          onChange={(theme) => settings.update({ theme })}
        />
      </div>
      <Switch
        label={t('ui.settings.pen')}
        checked={values.penOnly}
        onChange={(penOnly) => settings.update({ penOnly })}
      />
      <Switch
        label={t('ui.settings.single-keys')}
        checked={values.singleKeys}
        onChange={(singleKeys) => settings.update({ singleKeys })}
      />
      <h3>{t('ui.settings.keys')}</h3>
      <ul class="list keys">
        {commands.all
          .filter((command) => !command.hidden)
          .map((command) => (
            <li key={command.id} class="row">
              <span class="row-main">{t(command.title)}</span>
              <KeyButton command={command.id} />
            </li>
          ))}
      </ul>
      <Button
        kind="solid"
        icon="rotate-ccw"
        label={t('ui.settings.reset')}
        onClick={() => keymap.resetAll()}
      />
    </Dialog>
  );
}

/** Shows a command's shortcut; pressed, the next key becomes it. Backspace takes it away, Escape keeps it. */
function KeyButton({ command }: { command: string }) {
  const { keymap, commands } = useApp();
  const [listening, setListening] = useState(false);
  const [taken, setTaken] = useState<string | null>(null);
  const title = t(commands.get(command).title);
  return (
    <>
      {taken && <span class="muted">{t('ui.settings.taken', { name: taken })}</span>}
      <Button
        kind="solid"
        label={
          listening
            ? t('ui.settings.press')
            : keymap.keys(command).map(keymap.label.bind(keymap)).join('  ') || t('ui.settings.none')
        }
        aria-label={t('ui.settings.key-of', { name: title })}
        pressed={listening}
        onClick={() => {
          setTaken(null);
          setListening(!listening);
        }}
        onBlur={() => setListening(false)}
        onKeyDown={(event) => {
          if (!listening || event.key === 'Tab') return;
          event.preventDefault();
          event.stopPropagation();
          if (event.key === 'Escape') return setListening(false);
          if (event.key === 'Backspace') {
            keymap.rebind(command, []);
            return setListening(false);
          }
          const key = keymap.keyOf(event);
          if (!key) return;
          const owner = keymap.ownerOf(key, command);
          if (owner) {
            keymap.rebind(
              owner,
              keymap.keys(owner).filter((held) => held !== key),
            );
            setTaken(t(commands.get(owner).title));
          }
          keymap.rebind(command, [key]);
          setListening(false);
        }}
      />
    </>
  );
}
