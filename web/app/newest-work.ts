import type { Messages } from './messages';

/** Work that follows what is shown: the newest alone goes on, and what goes wrong with it is told. */
export class NewestWork {
  #abort = new AbortController();

  constructor(private readonly messages: Pick<Messages, 'failed'>) {}

  /** Ends what goes on. */
  end(): void {
    this.#abort.abort();
    this.#abort = new AbortController();
  }

  /** In the place of what went on. */
  start(work: (signal: AbortSignal) => Promise<void>): void {
    this.end();
    work(this.#abort.signal).catch((error: unknown) => this.messages.failed(error));
  }
}
