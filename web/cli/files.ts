// Files in and out. What is written appears complete, by rename, or not at all.

import { mkdir, readFile, rename, rm, stat, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { LissomError } from '../core/errors';

/** @throws LissomError `missing` where there is no such file, `file-unreadable` */
export async function readable(missing: string, file: string): Promise<Uint8Array> {
  try {
    return await readFile(file);
  } catch (error) {
    const { code = 'no reason given' } = error as NodeJS.ErrnoException;
    if (code === 'ENOENT')
      throw new LissomError(missing, `There is no file ${file}; check its name and folder.`);
    throw new LissomError('file-unreadable', `${file} cannot be read (${code}).`);
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
      const temporary = path.join(path.dirname(file), `.${path.basename(file)}.${process.pid}.tmp`);
      waiting.set(temporary, file);
      await writeFile(temporary, content);
    }
    // With everything written beside its place, all that can still stop a rename is a folder of that name.
    for (const file of files.keys()) await refuseFolder(file);
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

async function refuseFolder(file: string): Promise<void> {
  const there = await stat(file).catch(() => undefined);
  if (there?.isDirectory())
    throw Object.assign(new Error('a folder is in the way'), { code: 'EISDIR', path: file });
}
