// Three upright figures of one make, and a sleeve around one of them: small enough to be matched in a moment.

import { tube } from '../tools/blend/tube';

const SHAPE = { rings: 48, around: 20 } as const;

/** Wide at the hips and the chest. @param girth  of the whole */
const outline =
  (girth: number, waist: number) =>
  (share: number): number =>
    girth *
    (0.11 +
      0.04 * Math.exp(-(((share - 0.51) / 0.05) ** 2)) +
      0.05 * Math.exp(-(((share - 0.72) / 0.05) ** 2)) +
      waist * Math.exp(-(((share - 0.62) / 0.04) ** 2)));

function obj({ positions, triangles }: ReturnType<typeof tube>): string {
  const rows = (letter: string, values: ArrayLike<number>, add: number, digits: number) =>
    Array.from({ length: values.length / 3 }, (_, i) =>
      [letter, ...[0, 1, 2].map((k) => (values[3 * i + k]! + add).toFixed(digits))].join(' '),
    );
  return `${[...rows('v', positions, 0, 6), ...rows('f', triangles, 1, 0)].join('\n')}\n`;
}

const heights = { slim: 1, stout: 1, tall: 1.4 } as const;
export const NAMES = ['slim', 'stout', 'tall'] as const;

const figures = {
  slim: tube(outline(1, -0.02), { ...SHAPE, height: heights.slim }),
  stout: tube(outline(1.5, 0.03), { ...SHAPE, height: heights.stout }),
  tall: tube(outline(1.1, 0), { ...SHAPE, height: heights.tall }),
};

export const FIGURE_FILES = NAMES.map((name) => [`${name}.obj`, obj(figures[name])] as const);

/** Around the slim one's middle, open at both ends. */
export const SLEEVE = (() => {
  const { positions, triangles } = tube(() => 0.17, {
    rings: 12,
    around: 20,
    height: 0.3,
    shift: [0, 0.45, 0],
  });
  // Without the fans at its ends.
  return obj({ positions: positions.subarray(0, -6), triangles: triangles.subarray(0, 6 * 12 * 20) });
})();

/** Places on all three that are the same: four around each of three rings. */
const MARKED = [6, 24, 42].flatMap((ring) => [0, 5, 10, 15].map((at) => ring * SHAPE.around + at));

export const MATCHED = JSON.stringify({
  lissom: 1,
  models: Object.fromEntries(NAMES.map((name) => [name, { file: `${name}.obj` }])),
  steps: [
    {
      id: 'match 1',
      type: 'match',
      models: NAMES,
      markers: MARKED.map((vertex) => NAMES.map(() => vertex)),
    },
  ],
  outputs: [],
});
