// What a file may unfold to. A file comes from anyone: a kilobyte that shares its one mesh a million times is refused
// before the memory is set aside, and so is a gigabyte that no browser could hold.

import { LissomError } from '../core/errors';
import { inBytes } from '../core/sizes';
import { MAX_RECIPE_BYTES } from '../recipe/limits';

/** The kinds of files that are read. */
export type FileKind = 'mesh' | 'gltf' | 'strands' | 'project' | 'recipe' | 'picture';

interface Limits {
  /** Largest file of the kind, in bytes. */
  readonly file: number;
  /** Bytes in memory that any file may unfold to, however small it is … */
  readonly least: number;
  /** … and for each of its own bytes … */
  readonly perByte: number;
  /** … but no file to more than this. */
  readonly most: number;
}

const MB = 1e6;
const GB = 1e9;

/**
 * Measured: text unfolds to at most 50 times its size (lines of a letter each, kept for the way out), a binary mesh to 8,
 * glTF that repeats a mesh on purpose to some hundred times where it is small. A recipe's text is read as it is, and the
 * largest real one has 2 MB.
 */
const LIMITS: Readonly<Record<FileKind, Limits>> = {
  mesh: { file: 1 * GB, least: 16 * MB, perByte: 64, most: 2 * GB },
  // Its text becomes one string, and engines hold no longer ones.
  gltf: { file: 400 * MB, least: 32 * MB, perByte: 64, most: 2 * GB },
  strands: { file: 1 * GB, least: 16 * MB, perByte: 64, most: 2 * GB },
  project: { file: 1 * GB, least: 32 * MB, perByte: 64, most: 1 * GB },
  recipe: { file: MAX_RECIPE_BYTES, least: 0, perByte: 1, most: MAX_RECIPE_BYTES },
  picture: { file: 200 * MB, least: 1 * MB, perByte: 2, most: 400 * MB },
};

/** Largest file of any kind: for those who read one before they know what is in it. */
export const LARGEST_FILE = Math.max(...Object.values(LIMITS).map(({ file }) => file));

/** Bytes that a file of a kind and size may unfold to. */
export function allowance(kind: FileKind, size: number): number {
  const { least, perByte, most } = LIMITS[kind];
  return Math.min(most, least + perByte * size);
}

/** Counts what a reader sets aside for one file. */
export class Budget {
  readonly #allowed: number;
  #taken = 0;

  /**
   * @param file  name for messages
   * @param size  of the file, in bytes
   * @throws LissomError `file-too-large`
   */
  constructor(
    kind: FileKind,
    readonly file: string,
    private readonly size: number,
  ) {
    checkSize(kind, file, size);
    this.#allowed = allowance(kind, size);
  }

  get taken(): number {
    return this.#taken;
  }

  /**
   * Called before memory is set aside.
   *
   * @param bytes  of memory
   * @throws LissomError `file-unfolds-too-far`
   */
  take(bytes: number): void {
    this.expect(bytes);
    this.#taken += bytes;
  }

  /** Whether there is room for so much more: for what can be left out. */
  holds(bytes: number): boolean {
    return this.#taken + bytes <= this.#allowed;
  }

  /** As `take`, for what is only about to be taken: so that a file is refused before half of it has been read. */
  expect(bytes: number): void {
    if (this.holds(bytes)) return;
    const message =
      `${this.file} has ${inBytes(this.size)} and unfolds to more than ${inBytes(this.#allowed)}, which is refused: it ` +
      'repeats what it holds too often. Export it again with every part written once, or in parts.';
    throw new LissomError('file-unfolds-too-far', message);
  }
}

/**
 * @param size  of the file, in bytes
 * @throws LissomError `file-too-large`
 */
export function checkSize(kind: FileKind, file: string, size: number): void {
  const { file: most } = LIMITS[kind];
  if (size > most) throw tooLarge(file, size, most);
}

/** As `checkSize`, before the kind is known. @throws LissomError `file-too-large` */
export function checkFileSize(file: string, size: number): void {
  if (size > LARGEST_FILE) throw tooLarge(file, size, LARGEST_FILE);
}

function tooLarge(file: string, size: number, most: number): LissomError {
  const message = `${file} has ${inBytes(size)}; the limit is ${inBytes(most)}. Open a smaller file, or a part of it.`;
  return new LissomError('file-too-large', message);
}
