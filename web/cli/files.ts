// Files in and out. What is written appears complete, by rename, or not at all.

import { constants, type Stats } from 'node:fs';
import { type FileHandle, mkdir, open, rename, rm, stat, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { LissomError } from '../core/errors';
import { checkSize, type FileKind } from '../io/budget';

/** Devices and pipes may never end, or block before they begin. */
const WITHOUT_WAITING = constants.O_RDONLY | (constants.O_NONBLOCK ?? 0);

/** @throws LissomError `missing` where there is no such file, `file-unreadable`, `file-too-large` */
export async function readable(missing: string, file: string, kind: FileKind): Promise<Uint8Array> {
  let handle: FileHandle | undefined;
  try {
    handle = await open(file, WITHOUT_WAITING);
    const there = await handle.stat();
    if (!there.isFile()) throw Object.assign(new Error('not a file'), { code: `it is ${nameOf(there)}` });
    checkSize(kind, file, there.size);
    return await handle.readFile();
  } catch (error) {
    if (error instanceof LissomError) throw error;
    const { code = 'no reason given' } = error as NodeJS.ErrnoException;
    if (code === 'ENOENT')
      throw new LissomError(missing, `There is no file ${file}; check its name and folder.`);
    throw new LissomError('file-unreadable', `${file} cannot be read (${code}).`);
  } finally {
    await handle?.close();
  }
}

/**
 * Writes all files or none: each whole under another name first, then all renamed.
 *
 * @throws LissomError `cannot-write`
 */
export async function writeAll(files: ReadonlyMap<string, Uint8Array | string>): Promise<void> {
  const waiting = new Map<string, string>();
  try {
    for (const [file, content] of files) {
      await mkdir(path.dirname(file), { recursive: true });
      // Not named after the file: a name may be as long as the system allows.
      const temporary = path.join(path.dirname(file), `.lissom-${process.pid}-${waiting.size}.tmp`);
      waiting.set(temporary, file);
      await writeFile(temporary, content);
    }
    // With everything written beside its place, all that can still stop a rename is a folder of that name. A device would
    // be replaced by a file.
    for (const file of files.keys()) await refuseOther(file);
    for (const [temporary, file] of waiting) await rename(temporary, file);
  } catch (error) {
    for (const temporary of waiting.keys()) await rm(temporary, { force: true });
    const { code = 'no reason given', path: place = 'The result' } = error as NodeJS.ErrnoException;
    throw new LissomError(
      'cannot-write',
      `${place} cannot be written (${code}); nothing was changed.`,
      'crash',
    );
  }
}

async function refuseOther(file: string): Promise<void> {
  const there = await stat(file).catch(() => undefined);
  if (there && !there.isFile())
    throw Object.assign(new Error('something else is in the way'), { code: nameOf(there), path: file });
}

function nameOf(there: Stats): string {
  if (there.isDirectory()) return 'a folder';
  return there.isFIFO() || there.isSocket() ? 'a pipe' : 'a device';
}
