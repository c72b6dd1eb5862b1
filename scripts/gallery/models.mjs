// The gallery's models for the scripts that pick vertices on them.

import { readFileSync } from 'node:fs';
import { openSources } from '../lib/sources.mjs';
import { readPly } from './ply.mjs';

/** public/gallery/ */
export const folder = new URL('../../public/gallery/', import.meta.url);

/** Models that no file holds: what the app makes, and of which file. */
export const MADE = {
  'critter-scaled': {
    file: 'critter.ply',
    made: { subdivisions: 2, scales: { size: 0.014, height: 0.2, below: 0.2 } },
  },
};

const make = await maker();
const read = new Map();

/** @returns what `readPly` makes of a model; each is read once, whoever asks for it */
export function modelOf(name) {
  if (!read.has(name)) read.set(name, name in MADE ? made(name) : readPly(new URL(`${name}.ply`, folder)));
  return read.get(name);
}

function made(name) {
  const { positions, faceVertices } = make(name, readFileSync(new URL(MADE[name].file, folder)));
  const triples = (of) => Array.from({ length: of.length / 3 }, (_, i) => [...of.subarray(3 * i, 3 * i + 3)]);
  return { points: triples(positions), faces: triples(faceVertices), scalp: [] };
}

/** What makes them in the app, which is written in TypeScript. */
async function maker() {
  const server = await openSources();
  const { builtInAtOnce } = await server.ssrLoadModule('/web/io/built-in.ts');
  await server.close();
  return (name, bytes) => builtInAtOnce({ name, ...MADE[name] }, bytes).model;
}
