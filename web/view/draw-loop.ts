/** Draws on demand: a frame is asked for when something has changed, and costs nothing at rest. */
export class DrawLoop {
  #frame = 0;
  #last = 0;
  #times: number[] = [];
  #moving = false;
  #stopped = false;

  /**
   * @param advance  moves what moves by so many ms; whether there is more to come
   * @param draw     one picture
   */
  constructor(
    private readonly advance: (elapsed: number) => boolean,
    private readonly draw: () => void,
  ) {}

  request(): void {
    if (this.#frame === 0 && !this.#stopped) this.#frame = requestAnimationFrame((now) => this.#tick(now));
  }

  /** Pictures in the last second. */
  get rate(): number {
    const now = performance.now();
    return this.#times.filter((time) => now - time < 1000).length;
  }

  dispose(): void {
    this.#stopped = true;
    cancelAnimationFrame(this.#frame);
  }

  #tick(now: number): void {
    this.#frame = 0;
    // After a rest the first step counts as one ordinary frame.
    const elapsed = this.#moving ? now - this.#last : 16;
    this.#last = now;
    this.#moving = this.advance(elapsed);
    if (this.#moving) this.request();
    this.draw();
    this.#times = [...this.#times.filter((time) => now - time < 1000), now];
  }
}
