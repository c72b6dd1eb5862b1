// Rounds of inputs: in each every kind takes part once, with the round's seed.

import type { Generator } from './generator';
import { Random } from './random';

const found = import.meta.glob<Generator | readonly Generator[]>('./generators/*.ts', {
  eager: true,
  import: 'default',
});

export const generators: readonly Generator[] = Object.values(found)
  .flat()
  .sort((a, b) => (a.kind < b.kind ? -1 : 1));

export interface Finding {
  readonly kind: string;
  readonly seed: number;
  readonly error: unknown;
}

export interface Count {
  inputs: number;
  accepted: number;
  /** By code. */
  readonly refused: Map<string, number>;
}

export class Fuzzing {
  readonly counts = new Map<string, Count>();
  readonly findings: Finding[] = [];

  constructor(
    private readonly kinds: readonly Generator[],
    /** Told before each input, so that one that never ends is known. */
    private readonly begins: (kind: string, seed: number) => void = () => {},
  ) {}

  get inputs(): number {
    return [...this.counts.values()].reduce((sum, { inputs }) => sum + inputs, 0);
  }

  get kernelCalls(): number {
    return this.kinds.reduce((sum, { calls }) => sum + (calls?.() ?? 0), 0);
  }

  /** @param all  also the kinds that would not be in their turn */
  async round(seed: number, all = false): Promise<void> {
    for (const generator of this.kinds)
      if (all || seed % (generator.every ?? 1) === 0) await this.#one(generator, seed);
  }

  async #one(generator: Generator, seed: number): Promise<void> {
    const { kind } = generator;
    const count = this.counts.get(kind) ?? { inputs: 0, accepted: 0, refused: new Map() };
    this.counts.set(kind, count);
    count.inputs++;
    this.begins(kind, seed);
    try {
      const outcome = await generator.run(new Random(seed, kind));
      if (outcome === 'accepted') count.accepted++;
      else count.refused.set(outcome, (count.refused.get(outcome) ?? 0) + 1);
    } catch (error) {
      this.findings.push({ kind, seed, error });
    }
  }

  /** A line a kind. */
  table(): string {
    return [...this.counts]
      .map(([kind, { inputs, accepted, refused }]) => {
        const codes = [...refused].sort((a, b) => b[1] - a[1]).map(([code, n]) => `${code} ${n}`);
        return `${kind.padEnd(16)}${String(inputs).padStart(9)} inputs ${String(accepted).padStart(9)} accepted  ${codes.slice(0, 6).join(', ')}`;
      })
      .join('\n');
  }
}
