/** A small cache that forgets what was used longest ago, and says so, for what must be freed by hand. */
export class Lru<V> {
  readonly #held = new Map<string, { readonly value: V; readonly weight: number }>();
  #weight = 0;

  /** @param capacity  greatest sum of weights; the newest entry stays even if it alone weighs more */
  constructor(
    private readonly capacity: number,
    private readonly dropped: (value: V) => void = () => {},
  ) {}

  get(key: string): V | undefined {
    const found = this.#held.get(key);
    if (!found) return undefined;
    this.#held.delete(key);
    this.#held.set(key, found);
    return found.value;
  }

  set(key: string, value: V, weight = 1): void {
    this.delete(key);
    this.#held.set(key, { value, weight });
    this.#weight += weight;
    for (const oldest of this.#held.keys()) {
      if (this.#weight <= this.capacity || oldest === key) break;
      this.delete(oldest);
    }
  }

  delete(key: string): void {
    const found = this.#held.get(key);
    if (!found) return;
    this.#held.delete(key);
    this.#weight -= found.weight;
    this.dropped(found.value);
  }

  keys(): readonly string[] {
    return [...this.#held.keys()];
  }

  /** Forgets all without telling: for when what was held is already gone. */
  clear(): void {
    this.#held.clear();
    this.#weight = 0;
  }
}
