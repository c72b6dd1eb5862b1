import { createHash } from 'node:crypto';
import { readdirSync, readFileSync } from 'node:fs';
import path from 'node:path';

/** Hash of every file under `folder` but for the named entries at its top, and of `more`. */
export function fingerprint(folder, except = [], more = '') {
  const hash = createHash('sha256').update(more);
  const visit = (at) => {
    const entries = readdirSync(at, { withFileTypes: true }).sort((a, b) => (a.name < b.name ? -1 : 1));
    for (const entry of entries) {
      const file = path.join(at, entry.name);
      if (at === folder && except.includes(entry.name)) continue;
      if (entry.isDirectory()) visit(file);
      else hash.update(path.relative(folder, file)).update('\0').update(readFileSync(file)).update('\0');
    }
  };
  visit(folder);
  return hash.digest('hex');
}
