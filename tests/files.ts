import { readdirSync, statSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('..', import.meta.url));

/** Files below a folder of the repository, as paths from its root. */
export function filesUnder(folder: string, ends: readonly string[]): string[] {
  return readdirSync(path.join(root, folder)).flatMap((name) => {
    const file = `${folder}/${name}`;
    if (statSync(path.join(root, file)).isDirectory()) return filesUnder(file, ends);
    return ends.some((end) => file.endsWith(end)) ? [file] : [];
  });
}
