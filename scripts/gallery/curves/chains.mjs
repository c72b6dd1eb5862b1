// Chains of control points: laid along a limb as a stroke would have laid them, and bent.

const rounded = (n) => Math.round(n * 1e5) / 1e5 + 0;
export const roundedAll = (points) => points.map((point) => point.map(rounded));
export const radians = (degrees) => (degrees * Math.PI) / 180;

export const plus = (a, b, t = 1) => a.map((x, k) => x + t * b[k]);
export const minus = (a, b) => plus(a, b, -1);
const between = (a, b, t) => plus(a, minus(b, a), t);
const distance = (a, b) => Math.hypot(...minus(a, b));

/** A place of a polyline, by the share of its length. */
function placeOn(points, share) {
  const lengths = points.slice(1).map((p, k) => distance(p, points[k]));
  let left = share * lengths.reduce((a, b) => a + b);
  for (const [k, length] of lengths.entries()) {
    if (left <= length || k === lengths.length - 1) return between(points[k], points[k + 1], left / length);
    left -= length;
  }
}

export const evenly = (points, count) =>
  Array.from({ length: count }, (_, k) => placeOn(points, k / (count - 1)));

/** A vector turned about an axis (Rodrigues). */
function turnedAbout(axis, degrees, v) {
  const [c, s] = [Math.cos(radians(degrees)), Math.sin(radians(degrees))];
  const [x, y, z] = axis.map((a) => a / Math.hypot(...axis));
  const along = (1 - c) * (x * v[0] + y * v[1] + z * v[2]);
  const across = [y * v[2] - z * v[1], z * v[0] - x * v[2], x * v[1] - y * v[0]];
  return v.map((value, k) => c * value + s * across[k] + along * [x, y, z][k]);
}

/** What lies beyond point `at`, turned about that point. @param turns  axes and degrees, one after the other */
export function turnedFrom(points, at, turns) {
  return points.map((point, k) =>
    k <= at
      ? point
      : plus(
          points[at],
          turns.reduce((v, [axis, degrees]) => turnedAbout(axis, degrees, v), minus(point, points[at])),
        ),
  );
}

/** A chain whose segments are turned about an axis, each by `degrees(k)` more than the one before it. */
export const bent = (points, axis, degrees) =>
  points.slice(1).reduce((chain, _, k) => turnedFrom(chain, k, [[axis, degrees(k)]]), points);

/**
 * Straight bones with a short arc at each joint, so that what is bent by a joint is not creased by it.
 *
 * @param joints  from the root to the end; all but the last one bend
 * @param reach   how far the arc of each goes along its bones
 * @returns `rest`, which of its segments are bones, and `pose`: the chain with its joints bent by so many degrees
 */
export function jointed(joints, reach) {
  const rest = [];
  const rigid = [];
  const bends = []; // of each segment: the joint that it belongs to, and its share
  const add = (point, segment) => {
    rest.push(point);
    if (segment) bends.push(segment);
  };
  for (const [j, joint] of joints.slice(0, -1).entries()) {
    const along = (to, way) => between(joint, to, way / distance(joint, to));
    const [before, after] = [joints[j - 1], joints[j + 1]];
    if (before) {
      rigid.push(bends.length);
      add(along(before, reach[j]), { joint: j, share: 0 });
      add(along(before, reach[j] / 3), { joint: j, share: 0 });
      add(along(after, reach[j] / 3), { joint: j, share: 0.5 });
      add(along(after, reach[j]), { joint: j, share: 0.5 });
    } else {
      add(joint);
      add(along(after, reach[j] / 3), { joint: j, share: 0 });
      add(along(after, (2 * reach[j]) / 3), { joint: j, share: 0.5 });
      add(along(after, reach[j]), { joint: j, share: 0.5 });
    }
  }
  rigid.push(bends.length);
  add(joints.at(-1), { joint: 0, share: 0 });
  const pose = (axis, degrees) => bent(rest, axis, (k) => bends[k].share * degrees[bends[k].joint]);
  return { rest, rigid, pose };
}

/** @param posture  `posed`, `twist`, `scale`, `rigid` …; points are rounded here */
export const curve = (id, rest, { posed, ...posture } = {}, kind = 'skeleton') => ({
  id,
  kind,
  rest: roundedAll(rest),
  ...(posed && { posed: roundedAll(posed) }),
  ...posture,
});

export const curvesRecipe = (model, curves, { links = [], poses = [] } = {}) => ({
  lissom: 1,
  models: { [model]: { builtin: model } },
  steps: [{ id: 'curves 1', type: 'curves', model, curves, links, options: {}, poses }],
  outputs: [],
});
