/** What `Latest` does with what comes of an input. */
export interface LatestOptions<In, Out> {
  readonly work: (input: In, signal: AbortSignal) => Promise<Out>;
  readonly deliver: (output: Out, input: In) => void;
  readonly fail: (error: unknown, input: In) => void;
}

/**
 * Feeds slow work from a fast pointer: one call in flight, and of those waiting only the newest.
 * After `cancel` the call in flight is aborted and its answer, should one still come, is dropped.
 */
export class Latest<In, Out> {
  #waiting: { readonly input: In } | undefined;
  #running: Promise<void> | undefined;
  #abort = new AbortController();

  constructor(private readonly options: LatestOptions<In, Out>) {}

  get busy(): boolean {
    return this.#running !== undefined;
  }

  push(input: In): void {
    this.#waiting = { input };
    this.#running ??= this.#drain();
  }

  cancel(): void {
    this.#waiting = undefined;
    this.#abort.abort();
    this.#abort = new AbortController();
  }

  /** Resolves once nothing is in flight or waiting. */
  async settled(): Promise<void> {
    while (this.#running) await this.#running;
  }

  async #drain(): Promise<void> {
    // The first input is left waiting for the rest of this turn: pushes of one event arrive together.
    await Promise.resolve();
    for (let next = this.#waiting; next; next = this.#waiting) {
      this.#waiting = undefined;
      await this.#one(next.input, this.#abort.signal);
    }
    this.#running = undefined;
  }

  async #one(input: In, signal: AbortSignal): Promise<void> {
    try {
      const output = await this.options.work(input, signal);
      if (!signal.aborted) this.options.deliver(output, input);
    } catch (error) {
      if (!signal.aborted) this.options.fail(error, input);
    }
  }
}
