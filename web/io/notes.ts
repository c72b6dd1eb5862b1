import type { Finding } from '../core/errors';

/** What a reader did that its user may want to know: a finding with its sentence. */
export interface ImportNote extends Finding {
  readonly message: string;
}

/** Gathers notes by code: the first occurrence is described, the rest are counted. */
export class Notes {
  #notes = new Map<string, { first: string; count: number; repaired: boolean; where: string | undefined }>();

  /**
   * @param message   a whole sentence; of several with one code the first is kept
   * @param where     place of this occurrence, such as `line 12`
   * @param repaired  whether the reader mended it rather than left it out or as it was
   */
  add(code: string, message: string, where?: string, repaired = false): void {
    const known = this.#notes.get(code);
    if (known) known.count++;
    else this.#notes.set(code, { first: message, count: 1, repaired, where });
  }

  list(): ImportNote[] {
    return [...this.#notes].map(([code, { first, count, repaired, where }]) => ({
      code,
      count,
      examples: [],
      repaired,
      message: where ? `${first} (${where}${count > 1 ? ` and ${count - 1} more` : ''})` : first,
    }));
  }
}
