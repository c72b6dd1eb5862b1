import type { ButtonHTMLAttributes, ComponentChildren } from 'preact';
import { Icon } from './icon';

interface Props extends Omit<ButtonHTMLAttributes<HTMLButtonElement>, 'icon' | 'label'> {
  /** Always the accessible name; shown too unless `iconOnly`. */
  label: string;
  icon?: string;
  iconOnly?: boolean;
  kind?: 'quiet' | 'solid' | 'primary' | 'danger';
  pressed?: boolean;
  disabled?: boolean;
  shortcut?: string | undefined;
  children?: ComponentChildren;
}

export function Button({
  label,
  icon,
  iconOnly,
  kind = 'quiet',
  pressed,
  shortcut,
  children,
  ...rest
}: Props) {
  const look = `button ${kind} ${iconOnly ? 'square' : ''}`;
  return (
    <button
      type="button"
      {...rest}
      class={rest.class ? `${look} ${rest.class}` : look}
      aria-label={iconOnly ? label : undefined}
      aria-pressed={pressed}
      title={iconOnly ? (shortcut ? `${label} (${shortcut})` : label) : undefined}
    >
      {icon && <Icon name={icon} />}
      {!iconOnly && <span>{label}</span>}
      {!iconOnly && shortcut && <span class="shortcut">{shortcut}</span>}
      {children}
    </button>
  );
}
