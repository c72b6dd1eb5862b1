// The gallery's matches of models that nobody would call of one kind. Markers are places on shapes that are formulas
// (scripts/gallery/parts.mjs). Written by scripts/gallery.mjs.

import { builtIn } from './landmarks.mjs';

const matchStep = (models, markers, more) => ({ id: 'match 1', type: 'match', models, markers, ...more });

const recipe = (...step) => ({
  lissom: 1,
  models: builtIn(...step[0]),
  steps: [matchStep(...step)],
  outputs: [],
});

/** Of one hole both; the nut's edges stay sharp. Four places on each of four cuts across the ring. */
function nut() {
  const [TORUS, NUT] = [
    { around: 80, profile: 40, places: [0, 10, 20, 30] },
    { around: 96, profile: 44, places: [7, 18, 29, 40] },
  ];
  const markers = [0, 1, 2, 3].flatMap((quarter) =>
    [0, 1, 2, 3].map((k) =>
      [TORUS, NUT].map(({ around, profile, places }) => (quarter * around * profile) / 4 + places[k]),
    ),
  );
  return recipe(['torus', 'nut'], markers, { sharpAngle: 40 });
}

/** Seven balls that reach into one another, wrapped into one skin, and a rabbit in one piece. */
function bear() {
  const point = (...at) => ({ point: at });
  const both = (bear, rabbit) =>
    [1, -1].map((side) => [bear, rabbit].map(([x, y, z]) => point(side * x, y, z)));
  const middle = (bear, rabbit) => [point(...bear), point(...rabbit)];
  return recipe(
    ['bear', 'rabbit'],
    [
      middle([0, 1.18, 0.4], [0, 1.08, 0.37]),
      middle([0, 1.5, -0.1], [0, 1.38, -0.06]),
      middle([0, 0.62, 0.3], [0, 0.55, 0.29]),
      middle([0, 0.62, -0.3], [0, 0.62, -0.33]),
      middle([0, 0.2, -0.05], [0, 0.13, -0.05]),
      ...both([0.13, 1.47, 0.02], [0.21, 1.99, -0.06]),
      ...both([0.61, 0.59, 0.1], [0.57, 0.58, 0.25]),
      ...both([0.2, 0.18, 0.46], [0.22, 0.12, 0.52]),
    ],
    { first: 'wrap', genus: 0 },
  );
}

/** @returns name, title, model and recipe of each example */
export function matchExamples() {
  return [
    ['match-nut', 'Ring and nut', 'nut', nut()],
    ['match-bear', 'Toy bear and rabbit', 'bear', bear()],
  ];
}
