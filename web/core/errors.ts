/**
 * An error for people: what happened, where, what to do. `code` is stable, kebab-case and translatable.
 * `fault` says whose turn it is: the user's (`input`), the machine's (`memory`, `crash`), nobody's (`cancelled`).
 */
export class LissomError extends Error {
  constructor(
    readonly code: string,
    message: string,
    readonly fault: Fault = 'input',
  ) {
    super(message);
    this.name = 'LissomError';
  }
}

export type Fault = 'input' | 'solver' | 'memory' | 'crash' | 'cancelled';

export const cancelled = (): LissomError => new LissomError('cancelled', 'Cancelled.', 'cancelled');

export const isCancelled = (error: unknown): boolean =>
  error instanceof LissomError && error.fault === 'cancelled';

/** One line of an import report or a step's warnings. Vertex and face indices are those of the source model. */
export interface Finding {
  readonly code: string;
  readonly count: number;
  readonly examples: readonly number[];
  readonly repaired: boolean;
  /** The model it is about, where it is about one of several. */
  readonly model?: string;
}
