import { t } from '../../app/i18n';
import { useApp } from '../context';
import { Button } from './button';

interface Props {
  command: string;
  short?: string;
  iconOnly?: boolean;
  kind?: 'quiet' | 'solid' | 'primary' | 'danger';
  showShortcut?: boolean;
  role?: 'menuitem';
}

/** A button for a registered command: name, icon, shortcut and state all come from the registry. */
export function CommandButton({ command: id, short, iconOnly, kind, showShortcut, role }: Props) {
  const { commands, keymap } = useApp();
  const command = commands.get(id);
  const hint = keymap.hint(id);
  const checked = command.checked?.();
  return (
    <Button
      label={t(command.title)}
      {...(command.icon ? { icon: command.icon } : {})}
      {...(short ? { short } : {})}
      {...(iconOnly ? { iconOnly } : {})}
      {...(kind ? { kind } : {})}
      {...(role ? { role } : {})}
      {...(checked === undefined ? {} : { pressed: checked })}
      shortcut={iconOnly || short || showShortcut ? hint || undefined : undefined}
      disabled={!commands.isEnabled(id)}
      data-command={id}
      onClick={() => commands.run(id)}
    />
  );
}
