// Handles of deform steps as the gallery's recipes have them: vertices picked by geometry, moved by matrices.

import { setOf } from './vertex-set.mjs';

/** The vertices for which `inside(x, y, z)` holds. */
export const pick = (points, inside) => setOf(points.flatMap((point, v) => (inside(...point) ? [v] : [])));

/** Column-major, as all matrices here. */
export const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

const rounded = (n) => Math.round(n * 1e6) / 1e6 + 0;

/** Turn by `degrees` about an axis through `pivot` (Rodrigues), then move. */
export function turn(axis, degrees, pivot, move = [0, 0, 0]) {
  const length = Math.hypot(...axis);
  const [x, y, z] = axis.map((a) => a / length);
  const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
  const k = 1 - c;
  const columns = [
    [c + x * x * k, y * x * k + z * s, z * x * k - y * s],
    [x * y * k - z * s, c + y * y * k, z * y * k + x * s],
    [x * z * k + y * s, y * z * k - x * s, c + z * z * k],
  ];
  const turned = [0, 1, 2].map((i) => columns.reduce((sum, column, j) => sum + column[i] * pivot[j], 0));
  const to = [0, 1, 2].map((i) => pivot[i] - turned[i] + move[i]);
  return [...columns.flatMap((column) => [...column, 0]), ...to, 1].map(rounded);
}

/** First the last of the maps, then those before it. */
export const after = (...maps) =>
  maps.reduce((a, b) =>
    Array.from({ length: 16 }, (_, at) =>
      rounded([0, 1, 2, 3].reduce((sum, k) => sum + a[4 * k + (at % 4)] * b[4 * (at >> 2) + k], 0)),
    ),
  );

export const region = (name, vertices, matrix = identity) => ({ kind: 'region', vertices, matrix, name });

/** The vertex nearest to a place, as a handle that is moved by `by`. */
export function point(name, points, place, by = [0, 0, 0]) {
  const gap = (p) => Math.hypot(...p.map((x, k) => x - place[k]));
  const vertex = points.reduce((best, p, v) => (gap(p) < gap(points[best]) ? v : best), 0);
  const position = points[vertex].map((x, k) => rounded(x + by[k]));
  return { kind: 'point', vertices: [vertex], position, name };
}

/** @param how  another method, and further options */
export const deformStep = (id, model, roi, handles, { method = 'implicit', options = {} } = {}) => ({
  id,
  type: 'deform',
  model,
  roi,
  handles,
  method,
  options: { removeShear: true, scaleDetails: false, iterations: 1, coherenceRing: 1, ...options },
});

/** A built-in model with one such step. */
export const deformRecipe = (model, roi, handles, how) => ({
  lissom: 1,
  models: { [model]: { builtin: model } },
  steps: [deformStep('deform 1', model, roi, handles, how)],
  outputs: [],
});
