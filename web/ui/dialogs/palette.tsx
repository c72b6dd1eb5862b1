import { useEffect, useRef, useState } from 'preact/hooks';
import type { Command } from '../../app/commands';
import { t } from '../../app/i18n';
import { useAllWings, useApp } from '../context';
import { closeOnEscape } from '../controls/dialog';
import { Icon } from '../controls/icon';

/** Every command by name: type, arrow to it, Enter. */
export function Palette({ onClose }: { onClose: () => void }) {
  const { commands, keymap } = useApp();
  useAllWings();
  const [text, setText] = useState('');
  const [at, setAt] = useState(0);
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    const before = document.activeElement;
    dialog.current?.showModal();
    return () => {
      dialog.current?.close();
      if (before instanceof HTMLElement) before.focus();
    };
  }, []);

  const found = commands.all
    .filter((command) => !command.hidden && command.id !== 'help.palette')
    .map((command) => ({ command, rank: rank(t(command.title), text) }))
    .filter(({ rank: r }) => r < Infinity)
    .sort((a, b) => a.rank - b.rank)
    .map(({ command }) => command);
  const chosen = Math.min(at, found.length - 1);

  const take = (command: Command | undefined) => {
    if (!command || !commands.isEnabled(command.id)) return;
    onClose();
    commands.run(command.id);
  };

  return (
    <dialog
      ref={dialog}
      class="dialog palette"
      aria-label={t('ui.palette')}
      onKeyDown={closeOnEscape(onClose)}
      onClose={onClose}
      onClick={(e) => e.target === dialog.current && onClose()}
    >
      <input
        class="text"
        role="combobox"
        aria-expanded="true"
        aria-controls="palette-list"
        aria-activedescendant={found[chosen] ? `palette-${found[chosen].id}` : undefined}
        aria-label={t('ui.palette')}
        placeholder={t('ui.palette.type')}
        value={text}
        onInput={(e) => {
          setText(e.currentTarget.value);
          setAt(0);
        }}
        onKeyDown={(e) => {
          if (e.key === 'ArrowDown') setAt(Math.min(chosen + 1, found.length - 1));
          else if (e.key === 'ArrowUp') setAt(Math.max(chosen - 1, 0));
          else if (e.key === 'Enter') take(found[chosen]);
          else return;
          e.preventDefault();
        }}
      />
      <div id="palette-list" role="listbox" aria-label={t('ui.palette')} class="palette-list" tabIndex={-1}>
        {found.map((command, index) => (
          // biome-ignore lint/a11y/useKeyWithClickEvents: the combobox above owns the keys
          <div
            key={command.id}
            id={`palette-${command.id}`}
            role="option"
            tabIndex={-1}
            aria-selected={index === chosen}
            aria-disabled={!commands.isEnabled(command.id)}
            class="palette-row"
            ref={(row) => {
              if (index === chosen) row?.scrollIntoView({ block: 'nearest' });
            }}
            onPointerMove={() => setAt(index)}
            onClick={() => take(command)}
          >
            <Icon name={command.icon ?? 'command'} />
            <span>{t(command.title)}</span>
            {keymap.keys(command.id).map((key) => (
              <kbd key={key}>{keymap.label(key)}</kbd>
            ))}
          </div>
        ))}
        {found.length === 0 && <p class="muted palette-row">{t('ui.palette.none')}</p>}
      </div>
    </dialog>
  );
}

/** Lower is better: at the start, at a word's start, inside, letters in order; Infinity where it does not fit. */
function rank(title: string, typed: string): number {
  const name = title.toLowerCase();
  const wanted = typed.trim().toLowerCase();
  const found = name.indexOf(wanted);
  if (found === 0) return 0;
  if (found > 0) return name[found - 1] === ' ' ? 1 : 2;
  let from = 0;
  for (const letter of wanted.replaceAll(' ', '')) {
    from = name.indexOf(letter, from) + 1;
    if (from === 0) return Infinity;
  }
  return 3;
}
