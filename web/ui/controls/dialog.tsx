import type { ComponentChildren } from 'preact';
import { useEffect, useId, useRef } from 'preact/hooks';
import { Button } from './button';

interface Props {
  title: string;
  closeLabel: string;
  onClose: () => void;
  /** Whether the focus goes back to where it was; left out: always. Not where the dialog led on to something else. */
  returns?: () => boolean;
  wide?: boolean;
  children: ComponentChildren;
  footer?: ComponentChildren;
}

export const closeOnEscape = (close: () => void) => (event: KeyboardEvent) => {
  if (event.key !== 'Escape') return;
  event.preventDefault();
  close();
};

/** A native modal dialog: focus trap, Escape and the backdrop come with the platform. */
export function Dialog({ title, closeLabel, onClose, returns = () => true, wide, children, footer }: Props) {
  const ref = useRef<HTMLDialogElement>(null);
  const id = useId();
  useEffect(() => {
    const dialog = ref.current;
    const before = document.activeElement;
    if (dialog && !dialog.open) dialog.showModal();
    // Not the close button, which comes first: what the dialog is for, or else the dialog as a whole.
    (dialog?.querySelector<HTMLElement>('[data-first]') ?? dialog)?.focus();
    return () => {
      dialog?.close();
      // Closing alone gives the focus back, too.
      const after = returns() ? before : document.activeElement;
      if (after instanceof HTMLElement) returns() ? after.focus() : after.blur();
    };
  }, []);
  return (
    <dialog
      ref={ref}
      class={wide ? 'dialog wide' : 'dialog'}
      aria-labelledby={id}
      tabIndex={-1}
      // Browsers send `close` with the next picture only, which may be late: Escape is taken at once.
      onKeyDown={closeOnEscape(onClose)}
      onClose={onClose}
      onClick={(e) => e.target === ref.current && onClose()}
    >
      <header>
        <h2 id={id}>{title}</h2>
        <Button icon="x" iconOnly label={closeLabel} onClick={onClose} />
      </header>
      <div class="body">{children}</div>
      {footer && <footer>{footer}</footer>}
    </dialog>
  );
}
