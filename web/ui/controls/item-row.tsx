import type { ComponentChildren } from 'preact';
import { useState } from 'preact/hooks';
import { t } from '../../app/i18n';
import { Button } from './button';
import { Icon } from './icon';

/** As the history and the recipe keep names. */
const LONGEST_NAME = 64;

interface Props {
  name: string;
  icon: string;
  selected: boolean;
  hidden?: boolean;
  /** A word or a number at the end of the line. */
  children?: ComponentChildren;
  onSelect: () => void;
  onRename: (name: string) => void;
  /** Left out: it cannot be hidden. */
  onHide?: (hidden: boolean) => void;
  onRemove: () => void;
}

/** One line of a list of things a person has made: a click selects it, a double click renames it. */
export function ItemRow({ name, icon, selected, hidden = false, children, ...act }: Props) {
  const { onHide } = act;
  const [renaming, setRenaming] = useState(false);
  return (
    <li class={selected ? 'row selected' : 'row'}>
      {renaming ? (
        <input
          class="text"
          aria-label={t('ui.item.rename', { name })}
          value={name}
          maxLength={LONGEST_NAME}
          ref={(input) => input?.focus()}
          onBlur={(e) => {
            setRenaming(false);
            const typed = e.currentTarget.value.trim();
            if (typed && typed !== name) act.onRename(typed);
          }}
          onKeyDown={(e) => {
            if (e.key === 'Escape') e.currentTarget.value = name;
            if (e.key === 'Enter' || e.key === 'Escape') e.currentTarget.blur();
          }}
        />
      ) : (
        <button
          type="button"
          class="row-main"
          aria-pressed={selected}
          onClick={act.onSelect}
          onDblClick={() => setRenaming(true)}
        >
          <Icon name={icon} />
          <span>{name}</span>
          {children}
        </button>
      )}
      {selected && (
        <Button
          icon="pencil"
          iconOnly
          label={t('ui.item.rename', { name })}
          onClick={() => setRenaming(true)}
        />
      )}
      {onHide && (
        <Button
          icon={hidden ? 'eye-off' : 'eye'}
          iconOnly
          pressed={hidden}
          label={t('ui.item.hide', { name })}
          onClick={() => onHide(!hidden)}
        />
      )}
      <Button icon="trash-2" iconOnly label={t('ui.item.remove', { name })} onClick={act.onRemove} />
    </li>
  );
}
