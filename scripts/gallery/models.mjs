// The gallery's models for the scripts that pick vertices on them.

import { readPly } from './ply.mjs';

/** public/gallery/ */
export const folder = new URL('../../public/gallery/', import.meta.url);

const read = new Map();

/** @returns what `readPly` makes of a model; each is read once, whoever asks for it */
export function modelOf(name) {
  if (!read.has(name)) read.set(name, readPly(new URL(`${name}.ply`, folder)));
  return read.get(name);
}
