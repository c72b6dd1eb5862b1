// One kind of input. A file in `generators/` whose default export is one, or a list of them, takes part: nothing else has
// to be said anywhere, so that a new capability brings its own.

import { LissomError } from '../../web/core/errors';
import type { Random } from './random';

export interface Generator {
  readonly kind: string;
  /** In every how-manieth round it takes part; 1 when left out. What takes long takes part seldom. */
  readonly every?: number;
  /**
   * Makes an input and has it read.
   *
   * @returns what became of it: `accepted`, or the code it was refused with (`outcomeOf`)
   * @throws whatever nobody should see: a finding
   */
  run(random: Random): string | Promise<string>;
  /** The input that `run` would make, for whoever looks at a finding. */
  show?(random: Random): string;
  /** Calls of the kernel so far. */
  calls?(): number;
}

/** What messages must not have in them: words of the language or of a library. */
const RAW =
  /\bInvalid type\b|is not a function|Cannot read prop|\[object |\bundefined\b|Expected .* but received/;

/** A full stop at the end; of a recipe, how much else is wrong may follow. */
const SENTENCE = /[.…]( \(and \d+ more\))?$/;

/**
 * What becomes of an input: `accepted`, or the code of a refusal in words.
 *
 * @throws anything else that was thrown, and refusals that are no sentence or blame the program
 */
export async function outcomeOf(call: () => unknown): Promise<string> {
  try {
    await call();
    return 'accepted';
  } catch (error) {
    if (!(error instanceof LissomError)) throw error;
    const { code, fault, message } = error;
    if (fault === 'crash' || fault === 'memory')
      throw new Error(`${fault}: ${code}: ${message}`, { cause: error });
    if (!SENTENCE.test(message)) throw new Error(`no sentence: ${code}: ${message}`, { cause: error });
    if (RAW.test(message)) throw new Error(`raw words: ${code}: ${message}`, { cause: error });
    return code;
  }
}

/** @throws if it does not hold */
export function must(holds: boolean, what: string): asserts holds {
  if (!holds) throw new Error(what);
}
