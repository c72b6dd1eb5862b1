import type { ComponentChildren } from 'preact';
import { useId, useState } from 'preact/hooks';
import { Icon } from './icon';

interface Props {
  title: string;
  aside?: ComponentChildren;
  closed?: boolean;
  children: ComponentChildren;
}

/** A part of the side panel that folds away. */
export function Section({ title, aside, closed = false, children }: Props) {
  const [open, setOpen] = useState(!closed);
  const id = useId();
  return (
    <section class="section" aria-labelledby={id}>
      <header>
        <h2>
          <button
            type="button"
            id={id}
            class="section-title"
            aria-expanded={open}
            onClick={() => setOpen(!open)}
          >
            <Icon name={open ? 'chevron-down' : 'chevron-right'} />
            {title}
          </button>
        </h2>
        <span class="section-aside">{aside}</span>
      </header>
      {open && <div class="section-body">{children}</div>}
    </section>
  );
}
