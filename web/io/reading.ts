import { LissomError } from '../core/errors';
import type { Model } from '../core/model';
import { inBytes } from '../core/sizes';
import type { ImportNote } from './notes';

export interface ReadResult {
  readonly model: Model;
  /** What was left out, mended or worth knowing; empty for a plain file. */
  readonly notes: readonly ImportNote[];
}

/** A corner whose index the file got wrong: beyond any vertex, so that the kernel reports and skips the face. */
export const NO_INDEX = 0xffffffff;

/** The file ends before what it announced. `announced` and `present` in bytes. */
export function truncated(file: string, announced: number, present: number): LissomError {
  const message =
    `${file} announces ${inBytes(announced)} but holds only ${inBytes(present)}. ` +
    'It was cut short, probably while it was copied or downloaded: fetch it again.';
  return new LissomError('file-truncated', message);
}

/**
 * Compares what a header announces with the bytes that are there, before anything is allocated.
 *
 * @param what    the announced thing, such as `900000000 faces`
 * @param needed  the least number of bytes it can take
 * @throws LissomError `file-truncated`, or `count-too-large` where the number itself must be wrong
 */
export function checkAnnounced(file: string, what: string, needed: number, present: number): void {
  if (needed <= present) return;
  if (needed <= 16 * (present + 1024)) throw truncated(file, needed, present);
  const message =
    `${file} announces ${what}, which take at least ${inBytes(needed)}, but only ${inBytes(present)} follow. ` +
    'Its header is wrong: export the model again from the program that made it.';
  throw new LissomError('count-too-large', message);
}

/** A format of triangles and a model without a single usable one. */
export function nothingToWrite({ name }: Model, format: string): LissomError {
  const message = `${name} has no face with finite corners, and ${format} holds nothing else. Export it as PLY or OBJ.`;
  return new LissomError('nothing-to-export', message);
}
