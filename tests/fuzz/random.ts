/** Numbers by chance that a seed brings back: the same seed, the same input on every machine. */
export class Random {
  #state: number;

  /** @param stream  tells apart what begins with the same seed */
  constructor(seed: number, stream = '') {
    this.#state = seed >>> 0;
    for (let i = 0; i < stream.length; i++)
      this.#state = Math.imul(this.#state ^ stream.charCodeAt(i), 0x9e3779b1);
  }

  /** In [0, 1), by 32 bits (Mulberry32). */
  share(): number {
    this.#state = (this.#state + 0x6d2b79f5) | 0;
    let t = Math.imul(this.#state ^ (this.#state >>> 15), this.#state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  }

  /** A whole number from 0 to `count` − 1. */
  below(count: number): number {
    return Math.floor(this.share() * count);
  }

  chance(share: number): boolean {
    return this.share() < share;
  }

  pick<T>(items: readonly T[]): T {
    return items[this.below(items.length)]!;
  }

  /** Mostly a few, at times many. */
  few(most: number): number {
    return Math.floor(most ** this.share());
  }

  between(low: number, high: number): number {
    return low + this.share() * (high - low);
  }

  list<T>(length: number, item: (at: number) => T): T[] {
    return Array.from({ length }, (_, at) => item(at));
  }
}
