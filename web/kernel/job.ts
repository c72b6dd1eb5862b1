import { cancelled } from '../core/errors';
import type { Look } from './contract';

/** Milliseconds of work between two looks at the mailbox: short beside the eye, long beside the yield. */
const SLICE = 25;
/** Milliseconds between two progress messages. */
const PROGRESS_INTERVAL = 50;
/** Milliseconds between two looks: they are copied and drawn. */
const LOOK_INTERVAL = 250;

/** A request under way, as its handler sees it. */
export class Job {
  #reported: number;
  #shown: number;

  constructor(
    readonly signal: AbortSignal,
    private readonly report: (fraction: number) => void,
    private readonly now: () => number = () => performance.now(),
    private readonly show?: (look: Look) => void,
  ) {
    this.#reported = now();
    this.#shown = this.#reported;
  }

  /** Shows what is being made, where somebody looks and it is time for it. */
  look(seen: () => Look | undefined): void {
    if (!this.show || this.now() - this.#shown < LOOK_INTERVAL) return;
    const look = seen();
    if (look) this.show(look);
    this.#shown = this.now();
  }

  /** Between two slices of long work: reports, lets waiting messages in, throws if the caller gave up. */
  async checkpoint(fraction: number): Promise<void> {
    const time = this.now();
    if (time - this.#reported >= PROGRESS_INTERVAL) {
      this.#reported = time;
      this.report(fraction);
    }
    await breathe();
    if (this.signal.aborted) throw cancelled();
  }

  /** Runs `step` until it returns false, with a checkpoint after every slice, and a look where there is one to have. */
  async advance(step: () => boolean, fraction: () => number, seen?: () => Look | undefined): Promise<void> {
    for (let more = true; more; ) {
      const end = this.now() + SLICE;
      do more = step();
      while (more && this.now() < end);
      if (seen && more) this.look(seen);
      await this.checkpoint(fraction());
    }
  }
}

const resumes: (() => void)[] = [];
let channel: MessageChannel | undefined;

/** One turn of the event loop, without the 4 ms that nested timeouts cost in a worker. */
export function breathe(): Promise<void> {
  if (typeof setImmediate === 'function') return new Promise((resume) => setImmediate(resume));
  if (!channel) {
    channel = new MessageChannel();
    channel.port1.onmessage = () => resumes.shift()?.();
  }
  const { port2 } = channel;
  return new Promise((resume) => {
    resumes.push(resume);
    port2.postMessage(null);
  });
}
