// What is no creature: a bar, a band with one side, leaves that share an edge, and a snake in two pieces.

import { modelOf } from '../models.mjs';
import { bent, curve, curvesRecipe, evenly, radians } from './chains.mjs';

/** A bar that is bent and twisted at once. */
export function bar() {
  const heights = modelOf('bar').points.map(([, y]) => y);
  const [low, high] = [heights.reduce((a, b) => Math.min(a, b)), heights.reduce((a, b) => Math.max(a, b))];
  const rest = evenly(
    [
      [0, low, 0],
      [0, high, 0],
    ],
    9,
  );
  const twist = rest.map((_, k) => 22.5 * k);
  return curvesRecipe('bar', [
    curve('axis', rest, { posed: bent(rest, [0, 0, 1], (k) => (k === 0 ? 0 : -20)), twist, anchor: 'start' }),
  ]);
}

/** Half of the band lifted and pulled out. */
export function moebius() {
  const around = Array.from({ length: 9 }, (_, k) => {
    const angle = radians(-190 + 25 * k);
    return [Math.cos(angle), 0, Math.sin(angle)];
  });
  const posed = around.map(([x, , z], k) => {
    const lift = Math.sin((Math.PI * k) / 8) ** 2;
    return [x, 0.8 * lift, z * (1 + 0.35 * lift)];
  });
  return curvesRecipe('moebius', [curve('band', around, { posed, anchor: 'start' }, 'surface')]);
}

/** Three leaves of a book, two of them turned. */
export function sheets() {
  const leaf = (degrees) =>
    Array.from({ length: 6 }, (_, k) => {
      const out = 0.12 + 0.17 * k;
      return [out * Math.cos(radians(degrees)), 0, out * Math.sin(radians(degrees))];
    });
  const turned = (id, degrees, each) => {
    const rest = leaf(degrees);
    const posed = bent(rest, [0, 1, 0], (k) => (k === 0 ? 0 : each));
    return curve(id, rest, { posed, anchor: 'start' }, 'surface');
  };
  return curvesRecipe('sheets', [turned('first leaf', 90, -24), turned('second leaf', 210, -20)]);
}

/** One curve from tail to head, though the snake is cut through: it winds on the ground and rears up. */
export function snake() {
  const rest = evenly(
    [
      [-2, 0, 0],
      [1.8, 0, 0],
    ],
    13,
  );
  const winds = [0, 35, 25, -30, -45, -30, 20, 25, 0, 0, 0, 0];
  const rears = [0, 0, 0, 0, 0, 0, 0, 15, 35, 35, -30, -45];
  const wound = bent(rest, [0, 1, 0], (k) => winds[k]);
  return curvesRecipe('snake', [
    curve('back', rest, { posed: bent(wound, [0, 0, 1], (k) => rears[k]), anchor: 'start' }),
  ]);
}
