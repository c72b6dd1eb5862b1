// Which tab a stored document belongs to: one at a time, so that two tabs never write over each other.

export interface Claims {
  /**
   * @param patience  milliseconds to wait for a tab that has it and may just be going
   * @returns false while another tab has it
   */
  claim(id: string, patience?: number): Promise<boolean>;
  /** Whether no other tab has it; takes nothing, so that it is never in the way of the tab whose it is. */
  isFree(id: string): Promise<boolean>;
  release(id: string): void;
  /** @param listener  hears of a document that another tab turns out to have had before: it is not this tab's */
  onLost(listener: (id: string) => void): void;
}

/** @param tab  a name that no other tab has */
export function tabClaims(tab: string): Claims {
  // Locks exist on https and localhost only.
  return navigator.locks
    ? new LockClaims(navigator.locks)
    : new ChannelClaims(new BroadcastChannel(NAME), tab);
}

const NAME = 'lissom';

/** Through Web Locks, which the browser gives up for a tab that is closed or crashes. */
export class LockClaims implements Claims {
  /** Gives the lock back; the promise says when that is done. */
  readonly #held = new Map<string, () => Promise<unknown>>();
  readonly #releasing = new Map<string, Promise<unknown>>();

  constructor(private readonly locks: LockManager) {}

  async claim(id: string, patience = 0): Promise<boolean> {
    await this.#releasing.get(id);
    if (this.#held.has(id)) return true;
    const options = patience > 0 ? { signal: AbortSignal.timeout(patience) } : { ifAvailable: true };
    return new Promise((answer) => {
      const over: Promise<unknown> = this.locks
        .request(`${NAME}:${id}`, options, (lock) => {
          answer(lock !== null);
          if (!lock) return undefined;
          return new Promise<void>((release) => {
            this.#held.set(id, () => {
              release();
              return over;
            });
          });
        })
        .catch((error: unknown) => answer(!isTimeout(error)));
    });
  }

  async isFree(id: string): Promise<boolean> {
    if (this.#held.has(id)) return true;
    const { held = [] } = await this.locks.query().catch(() => ({ held: [] as LockInfo[] }));
    return !held.some(({ name }) => name === `${NAME}:${id}`);
  }

  release(id: string): void {
    const release = this.#held.get(id);
    if (!release) return;
    this.#held.delete(id);
    const over = release().then(() => this.#releasing.delete(id));
    this.#releasing.set(id, over);
  }

  /** The browser never gives a lock to two tabs. */
  onLost(): void {}
}

const isTimeout = (error: unknown): boolean =>
  error instanceof DOMException && (error.name === 'TimeoutError' || error.name === 'AbortError');

type Message =
  | { readonly ask: string; readonly from: string }
  | { readonly look: string; readonly from: string }
  | { readonly mine: string; readonly to: string };

/** How long the other tabs have to say that a document is theirs, in milliseconds. */
export const ANSWER_TIME = 250;

/**
 * By asking the other tabs, where there are no locks. A tab too busy or too deep asleep to answer in time
 * answers when it wakes: whoever asked hears of it through `onLost`.
 */
export class ChannelClaims implements Claims {
  readonly #held = new Set<string>();
  readonly #asking = new Map<string, (answer: boolean) => void>();
  /** Those who only want to know. */
  readonly #looking = new Map<string, (answer: boolean) => void>();
  #lost: (id: string) => void = () => {};

  /** @param tab  a name that no other tab has */
  constructor(
    private readonly channel: Pick<BroadcastChannel, 'postMessage' | 'onmessage'>,
    private readonly tab: string,
  ) {
    channel.onmessage = ({ data }: MessageEvent<Message>) => this.#hear(data);
  }

  async claim(id: string, patience = 0): Promise<boolean> {
    if (this.#held.has(id)) return true;
    const late = performance.now() + patience;
    let isFree = await this.#answer(id, this.#asking, { ask: id, from: this.tab });
    while (!isFree && performance.now() < late) {
      await new Promise((go) => setTimeout(go, ANSWER_TIME));
      isFree = await this.#answer(id, this.#asking, { ask: id, from: this.tab });
    }
    if (isFree) this.#held.add(id);
    return isFree;
  }

  async isFree(id: string): Promise<boolean> {
    return this.#held.has(id) || this.#answer(id, this.#looking, { look: id, from: this.tab });
  }

  release(id: string): void {
    this.#held.delete(id);
  }

  onLost(listener: (id: string) => void): void {
    this.#lost = listener;
  }

  /** @returns false as soon as another tab says that it has the document */
  async #answer(
    id: string,
    waiting: Map<string, (answer: boolean) => void>,
    question: Message,
  ): Promise<boolean> {
    const isFree = await new Promise<boolean>((answer) => {
      waiting.set(id, answer);
      this.#say(question);
      setTimeout(() => answer(true), ANSWER_TIME);
    });
    waiting.delete(id);
    return isFree;
  }

  #hear(message: Message): void {
    if ('ask' in message) {
      const { ask: id, from } = message;
      const asking = this.#asking.get(id);
      // Of two tabs that ask at the same time, the one whose name comes first has it.
      if (this.#held.has(id) || (asking && this.tab < from)) this.#say({ mine: id, to: from });
      else asking?.(false);
    } else if ('look' in message) {
      if (this.#held.has(message.look)) this.#say({ mine: message.look, to: message.from });
    } else if (message.to === this.tab) {
      const id = message.mine;
      this.#asking.get(id)?.(false);
      this.#looking.get(id)?.(false);
      if (this.#held.delete(id)) this.#lost(id);
    }
  }

  #say(message: Message): void {
    this.channel.postMessage(message);
  }
}
