import type { ComponentChildren } from 'preact';
import { useId, useRef } from 'preact/hooks';
import { Button } from './button';

interface Props {
  label: string;
  icon?: string;
  iconOnly?: boolean;
  align?: 'start' | 'end';
  children: ComponentChildren;
}

/** A button with a popover under it: light dismiss and Escape are the platform's, arrows move through it. */
export function Menu({ label, icon, iconOnly, align = 'start', children }: Props) {
  const id = useId();
  const panel = useRef<HTMLDivElement>(null);
  const anchor = useRef<HTMLSpanElement>(null);

  const place = (event: Event) => {
    if ((event as ToggleEvent).newState !== 'open') return;
    const box = anchor.current!.getBoundingClientRect();
    const style = panel.current!.style;
    style.top = `${box.bottom + 4}px`;
    style.left = align === 'start' ? `${box.left}px` : 'auto';
    style.right = align === 'end' ? `${window.innerWidth - box.right}px` : 'auto';
  };

  const step = (event: KeyboardEvent) => {
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!by) return;
    event.preventDefault();
    const items = [...panel.current!.querySelectorAll<HTMLElement>('button:not(:disabled)')];
    const at = items.indexOf(document.activeElement as HTMLElement);
    items.at((at + by + items.length) % items.length)?.focus();
  };

  return (
    <span ref={anchor}>
      <Button
        label={label}
        {...(icon ? { icon } : {})}
        {...(iconOnly ? { iconOnly } : {})}
        popovertarget={id}
        aria-haspopup="menu"
      />
      <div
        id={id}
        ref={panel}
        popover="auto"
        class="popover"
        role="menu"
        tabIndex={-1}
        aria-label={label}
        onBeforeToggle={place}
        onKeyDown={step}
        onClick={() => panel.current?.hidePopover()}
      >
        {children}
      </div>
    </span>
  );
}
