import type { Signal } from '@preact/signals';
import { isCancelled, LissomError } from '../core/errors';
import type { MessageService } from './api';
import { t, tCode } from './i18n';
import type { State, Toast } from './state';

/** More at once than this and the oldest goes. */
const MOST = 4;
/** Good news goes by itself, in milliseconds; with a button it stays longer. What went wrong stays. */
const SHOWN = 6000;
const SHOWN_WITH_ACTION = 20_000;

export class Messages implements MessageService {
  #nextId = 1;
  readonly #toasts: Signal<readonly Toast[]>;

  constructor(state: Pick<State, 'toasts'>) {
    this.#toasts = state.toasts;
  }

  toast(kind: Toast['kind'], text: string, action?: Toast['action']): void {
    const toast = { id: this.#nextId++, kind, text, ...(action && { action }) };
    const others = this.#toasts.value.filter((each) => each.text !== text);
    this.#toasts.value = [...others, toast].slice(-MOST);
    if (kind === 'info' || kind === 'good')
      setTimeout(() => this.dismiss(toast.id), action ? SHOWN_WITH_ACTION : SHOWN);
  }

  dismiss(id: number): void {
    this.#toasts.value = this.#toasts.value.filter((each) => each.id !== id);
  }

  failed(error: unknown): void {
    if (isCancelled(error) || isAbort(error)) return;
    this.toast('bad', errorText(error));
  }
}

/** Whatever was thrown as one sentence for a person. */
export function errorText(error: unknown): string {
  if (error instanceof LissomError) {
    const text = tCode('error.', error.code, 'error.unknown', { detail: error.message });
    // A sentence that names things was filled in where they were known.
    return /\{\w+\}/.test(text) ? error.message : text;
  }
  return t('error.unexpected', { detail: error instanceof Error ? error.message : String(error) });
}

/** The person closed a file dialog. */
const isAbort = (error: unknown): boolean => error instanceof DOMException && error.name === 'AbortError';
