import { accessSync, constants } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = fileURLToPath(new URL('../..', import.meta.url)).replace(/[\\/]$/, '');

/** Full path of a program, or undefined. */
export function onPath(program) {
  const extensions = process.platform === 'win32' ? ['.exe', '.bat', '.cmd'] : [''];
  const folders = (process.env.PATH ?? '').split(path.delimiter);
  return folders
    .flatMap((folder) => extensions.map((end) => path.join(folder, program + end)))
    .find(executable);
}

export function executable(file) {
  try {
    accessSync(file, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

/** A Chromium of the system's own: CHROMIUM_PATH, else Debian's. */
export const chromium = () =>
  [process.env.CHROMIUM_PATH, '/usr/bin/chromium'].find((file) => file && executable(file));
