/** Which tab a stored document belongs to: one at a time, so that two tabs never write over each other. */
export interface Claims {
  /** @returns false while another tab has it */
  claim(id: string): Promise<boolean>;
  release(id: string): void;
}

/** Through Web Locks, which the browser gives up for a tab that is closed or crashes. */
export class TabClaims implements Claims {
  readonly #held = new Map<string, () => void>();

  constructor(private readonly locks: LockManager | undefined) {}

  claim(id: string): Promise<boolean> {
    const { locks } = this;
    if (!locks || this.#held.has(id)) return Promise.resolve(true);
    return new Promise((answer) => {
      locks
        .request(`lissom:${id}`, { ifAvailable: true }, (lock) => {
          answer(lock !== null);
          return lock ? new Promise<void>((release) => this.#held.set(id, release)) : undefined;
        })
        .catch(() => answer(true));
    });
  }

  release(id: string): void {
    this.#held.get(id)?.();
    this.#held.delete(id);
  }
}
