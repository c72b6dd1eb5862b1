// The gallery's matches: models that were made from one another, so that a vertex of one is the same place of the other. What
// the match is told of that are a few markers, far from each other. Written by scripts/gallery.mjs.

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

export const matchExamples = () => [
  ['match-heads', 'Two heads', 'head-elf', example(['head-female', 'head-elf'], 18, HEAD_EDGE)],
  ['match-bodies', 'Two bodies', 'body-male', example(['body-female', 'body-male'], 22, BODY_EDGE)],
];
