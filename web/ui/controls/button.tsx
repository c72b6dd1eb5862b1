import type { ButtonHTMLAttributes, ComponentChildren } from 'preact';
import { Icon } from './icon';

interface Props extends Omit<ButtonHTMLAttributes<HTMLButtonElement>, 'icon' | 'label'> {
  /** Always the accessible name; shown too unless `iconOnly`. */
  label: string;
  /** Shown in its place where there is little room; must begin the label. */
  short?: string;
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
  short,
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
      aria-label={iconOnly || short ? label : undefined}
      aria-pressed={pressed}
      title={iconOnly || short ? (shortcut ? `${label} (${shortcut})` : label) : undefined}
    >
      {icon && <Icon name={icon} />}
      {!iconOnly && <span>{short ?? label}</span>}
      {!iconOnly && !short && shortcut && <span class="shortcut">{shortcut}</span>}
      {children}
    </button>
  );
}
