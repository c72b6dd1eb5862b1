// Hair files and lines of an OBJ: damaged, read, written in every format.

import type { Groom } from '../../../web/core/strands';
import { readStrands, type StrandFormat, writeStrands } from '../../../web/io';
import { makeModel } from '../../io/make-model';
import { type Generator, must, outcomeOf } from '../generator';
import { bytesOf, mutateBytes, mutateText, textOf } from '../mutate';

const GROOM: Groom = {
  name: 'g',
  strands: {
    offsets: Uint32Array.of(0, 2, 5, 9),
    points: Float32Array.from({ length: 27 }, (_, i) => Math.sin(i)),
    origin: [0, 0, 0],
    look: { thickness: 0.01, taper: 0.3, color: '#403020', colorVariation: 0.2 },
  },
  head: makeModel([0, 0, 0, 1, 0, 0, 0, 1, 0], [[0, 1, 2]]),
};
const OPTIONS = { centimetresPerUnit: 1 };
const HAIR = writeStrands(GROOM, 'hair', OPTIONS);
const LINES = textOf(writeStrands(GROOM, 'obj', OPTIONS));
const FORMATS: readonly StrandFormat[] = ['hair', 'usda', 'abc', 'glb', 'obj', 'ply'];

const strands: Generator = {
  kind: 'strands',
  run(random) {
    const file = random.chance(0.5)
      ? mutateBytes(random, HAIR)
      : random.chance(0.7)
        ? bytesOf(mutateText(random, LINES))
        : mutateBytes(random, bytesOf(LINES));
    return outcomeOf(async () => {
      const groom = readStrands(file, 'a.hair');
      const { offsets, points } = groom.strands;
      must(3 * offsets.at(-1)! === points.length, 'offsets that do not span the points');
      must(points.every(Number.isFinite), 'a point that is no number');
      for (const format of FORMATS) await outcomeOf(() => writeStrands(groom, format, OPTIONS));
    });
  },
};
export default strands;
