// The gallery's matches. People were made from one another, so that a vertex of one is the same place of the other: what the
// match is told of that are a few markers, far from each other. Rings and toys are formulas (scripts/gallery/parts.mjs), their
// markers places on those. Written by scripts/gallery.mjs.

import { builtIn } from './landmarks.mjs';
import { modelOf } from './models.mjs';

/** So many vertices of a model, each as far from those before as may be; the first is the foremost. */
function spread(name, count) {
  const { points } = modelOf(name);
  const front = points.reduce((best, [, , z], v) => (z > points[best][2] ? v : best), 0);
  const found = [front];
  const gaps = points.map(() => Number.POSITIVE_INFINITY);
  while (found.length < count) {
    const [x, y, z] = points[found.at(-1)];
    points.forEach((p, v) => {
      gaps[v] = Math.min(gaps[v], Math.hypot(p[0] - x, p[1] - y, p[2] - z));
    });
    found.push(gaps.reduce((best, gap, v) => (gap > gaps[best] ? v : best), 0));
  }
  return found;
}

/** Markers that are spread over the last of the models, on all of them. */
const example = (models, count, edgeLength) => ({
  lissom: 1,
  models: Object.fromEntries(models.map((name) => [name, { builtin: name }])),
  steps: [
    {
      id: 'match 1',
      type: 'match',
      models,
      markers: spread(models.at(-1), count).map((vertex) => models.map(() => vertex)),
      edgeLength,
    },
  ],
});

/** Twice the models' own: skins that are made in a few seconds. */
const HEAD_EDGE = 0.006;
const BODY_EDGE = 0.02;

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

/** Seven eggs, closed each by itself, that reach into one another, and a rabbit in one piece. */
function bear() {
  const point = (...at) => ({ point: at });
  const both = (bear, rabbit) =>
    [1, -1].map((side) => [bear, rabbit].map(([x, y, z]) => point(side * x, y, z)));
  const middle = (bear, rabbit) => [point(...bear), point(...rabbit)];
  return recipe(
    ['bear', 'rabbit'],
    [
      middle([0, 1.2, 0.32], [0, 1.08, 0.37]),
      middle([0, 1.22, -0.26], [0, 1.13, -0.2]),
      middle([0, 0.58, 0.3], [0, 0.55, 0.29]),
      middle([0, 0.62, -0.3], [0, 0.62, -0.33]),
      middle([0, 0.2, -0.05], [0, 0.13, -0.05]),
      middle([0, 1.5, 0.03], [0, 1.4, 0.08]),
      ...both([0.23, 1.59, 0.02], [0.21, 2, -0.06]),
      ...both([0.64, 0.78, 0.08], [0.57, 0.58, 0.25]),
      ...both([0.2, 0.25, 0.46], [0.22, 0.12, 0.52]),
    ],
    {},
  );
}

export const matchExamples = () => [
  ['match-heads', 'Two heads', 'head-elf', example(['head-female', 'head-elf'], 18, HEAD_EDGE)],
  ['match-bodies', 'Two bodies', 'body-male', example(['body-female', 'body-male'], 22, BODY_EDGE)],
  ['match-nut', 'Ring and nut', 'nut', nut()],
  ['match-bear', 'Toy bear and rabbit', 'bear', bear()],
];
