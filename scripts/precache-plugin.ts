// Writes the list of a build's files into its service worker, with a version that changes when any of them does.

import { createHash } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import type { Plugin } from 'vite';

const WORKER = 'sw.js';
const PLACE = /\/\* build \*\/ \{.*?\}/;

/** @param further  files beside the built ones that a first visit needs */
export function precache(further: readonly string[]): Plugin {
  return {
    name: 'lissom:precache',
    apply: 'build',
    writeBundle({ dir }, bundle) {
      writePrecacheList(dir!, [...Object.keys(bundle), ...further]);
    },
  };
}

/** @param dir  a built site, with a service worker in it. @returns the version */
export function writePrecacheList(dir: string, files: readonly string[]): string {
  const sorted = [...new Set(files)].sort();
  const digest = createHash('sha256');
  for (const file of sorted) digest.update(file).update(readFileSync(path.join(dir, file)));
  const version = digest.digest('hex').slice(0, 16);
  const worker = path.join(dir, WORKER);
  const source = readFileSync(worker, 'utf8');
  if (!PLACE.test(source)) throw new Error(`${WORKER} has no place for the list of files.`);
  // The start page is asked for by the site's own address.
  const addresses = sorted.map((file) => (file === 'index.html' ? './' : file));
  const list = JSON.stringify({ version, files: addresses });
  writeFileSync(
    worker,
    source.replace(PLACE, () => `/* build */ ${list}`),
  );
  return version;
}
