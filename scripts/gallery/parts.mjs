// The gallery's models by formula: parts made to be merged with others, one of four holes, and
// what curves bend though it has one side, three at an edge, or is in two pieces. Writes
// public/gallery/<name>.ply. Run by hand when a shape changes, and scripts/gallery.mjs after it:
// node scripts/gallery/parts.mjs [name ...]

import { writeFileSync } from 'node:fs';
import { blend, box, capsule, clamp, cylinder } from './distances.mjs';
import { halves, implicitSurface } from './implicit-surface.mjs';
import { folder } from './models.mjs';
import { plyOf } from './ply.mjs';
import { pointsOf, soupOf } from './scans.mjs';
import { shoeOf } from './shoe.mjs';

/** A pipe with a flange and four branches, all as wide: they end at y = 0. */
function pipes() {
  const branches = [-0.75, -0.25, 0.25, 0.75];
  return implicitSurface({
    low: [-1.2, 0, -0.4],
    high: [1.48, 1.4, 0.88],
    cell: 0.04,
    opening: (_x, y) => (y < 0.3 ? 0 : undefined),
    downward: true,
    inside: (...p) => {
      const [x, y, z] = p;
      const pipe = blend(
        0.05,
        capsule(p, [-0.95, 0.95, 0.4], [1.15, 0.95, 0.4], 0.2),
        cylinder(p, 0, [0.95, 0.4], 1.22, 1.36, 0.33, 0.05),
        cylinder(p, 0, [0.95, 0.4], -0.06, 0.06, 0.25, 0.05),
      );
      const branch = branches.map((at) =>
        // Straight up from the opening, then a quarter turn into the pipe.
        blend(
          0.02,
          Math.max(Math.hypot(x - at, z) - 0.13, y - 0.55),
          y >= 0.55 && z <= 0.4 ? Math.hypot(x - at, Math.hypot(y - 0.55, z - 0.4) - 0.4) - 0.13 : 9,
        ),
      );
      const mouth = cylinder(p, 0, [0.95, 0.4], 0.95, 2, 0.14, 0.04);
      return -blend(0.05, -blend(0.14, pipe, Math.min(...branch)), mouth);
    },
  });
}

/** A block with cooling fins and four cylinders of different sizes and heights, open at the top. */
function block() {
  const stubs = [
    [-0.8, 0, 0.11, 0.72],
    [-0.3, 0.06, 0.19, 0.64],
    [0.28, -0.05, 0.15, 0.8],
    [0.82, 0.02, 0.22, 0.68],
  ];
  return implicitSurface({
    low: [-1.36, -0.2, -0.6],
    high: [1.36, 0.88, 0.6],
    cell: 0.04,
    opening: (x, y, z) =>
      y > 0.5 ? stubs.find(([cx, cz, r]) => Math.hypot(x - cx, z - cz) < r + 0.1)?.[3] : undefined,
    inside: (...p) => {
      const [x, y, z] = p;
      const body = box(p, [0, 0.14, 0], [1.22, 0.24, 0.42], 0.09);
      const fins = [-0.02, 0.14, 0.3].map((at) => box(p, [0, at - 0.02, 0], [1.28, 0.045, 0.5], 0.04));
      const cylinders = stubs.map(([cx, cz, r]) => Math.max(Math.hypot(x - cx, z - cz) - r, 0.2 - y));
      return blend(0.1, blend(0.04, body, ...fins), Math.min(...cylinders));
    },
  });
}

/** A key to wind a clockwork with: two rings on a shaft, open at its flared foot (genus 2). */
function key() {
  return implicitSurface({
    low: [-0.64, 0, -0.4],
    high: [0.64, 1.2, 0.4],
    cell: 0.032,
    opening: (_x, y) => (y < 0.2 ? 0 : undefined),
    downward: true,
    inside: (...p) => {
      const [x, y, z] = p;
      const ring = Math.hypot(Math.hypot(Math.abs(x) - 0.27, y - 0.8) - 0.19, z) - 0.075;
      const shaft = Math.max(Math.hypot(x, z) - 0.075, y - 0.8);
      const collar = cylinder(p, 1, [0, 0], 0.3, 0.42, 0.135, 0.04);
      // The foot widens to lie flat on what the key is set on.
      const foot =
        y > 0.3
          ? 9
          : (Math.hypot(x, z) - 0.075 - 0.004 / (y + 0.0135)) /
            Math.hypot(1, Math.min(3, 0.004 / (y + 0.0135) ** 2));
      return blend(0.05, blend(0.06, ring, shaft, collar), foot);
    },
  });
}

/** A caterpillar whose body is four rings, one behind the other: one surface of four holes (genus 4). */
function loops() {
  const rings = [0, 1, 2, 3].map((i) => ({
    x: 0.84 * (i - 1.5),
    radius: 0.44 - 0.03 * i,
    // Each leans to the other side than the one before.
    lean: i % 2 ? -0.5 : 0.5,
  }));
  const ring = ([x, y, z], { x: at, radius, lean }) => {
    const [c, s] = [Math.cos(lean), Math.sin(lean)];
    const [up, out] = [c * (y - 0.72) + s * z, c * z - s * (y - 0.72)];
    return Math.hypot(Math.hypot(x - at, up) - radius, out) - 0.13;
  };
  /** Two feet under the lowest place of a ring, where it leans to. */
  const feet = ({ x, radius, lean }) => {
    const [y, z] = [0.72 - radius * Math.cos(lean), -radius * Math.sin(lean)];
    return [-0.17, 0.17].map((to) => [
      [x, y, z],
      [x + to, 0.07, 1.5 * z],
    ]);
  };
  return implicitSurface({
    low: [-2.4, -0.03, -0.75],
    high: [2.49, 1.71, 0.75],
    cell: 0.03,
    inside: (...p) => {
      const [x, y, z] = p;
      const body = blend(0.12, ...rings.map((each) => ring(p, each)));
      const head = Math.hypot(x - 1.86, y - 0.9, z) - 0.3;
      const neck = capsule(p, [1.55, 0.74, 0], [1.8, 0.85, 0], 0.15);
      const tail = capsule(p, [-1.66, 0.72, 0], [-2.2, 1.02, 0], 0.07);
      const feelers = capsule([x, y, Math.abs(z)], [1.95, 1.1, 0.1], [2.08, 1.52, 0.24], 0.05);
      const legs = rings.flatMap(feet).map(([from, to]) => capsule(p, from, to, 0.07));
      return blend(0.08, body, head, neck, tail, feelers, ...legs);
    },
  });
}

const mix = (a, b, t) => a.map((x, k) => x + t * (b[k] - x));
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => a.map((x) => x / Math.hypot(...a));

/** A dragon's wing, spread along +x with its leading edge to +z, open at its flared root in the plane x = 0. */
function wing() {
  const [rows, around] = [72, 44];
  const [ROOT, ARM, FINGERS] = [0.11, 0.045, 4];
  /** The arm: out and up to the wrist, then out and down. */
  const arm = (s) => {
    const [a, b, c, d] = [
      [0, 0, 0],
      [0.75, 0.15, 0.05],
      [0.95, 1.05, 0.3],
      [2.1, 0.75, -0.35],
    ];
    const [ab, bc, cd] = [mix(a, b, s), mix(b, c, s), mix(c, d, s)];
    return mix(mix(ab, bc, s), mix(bc, cd, s), s);
  };
  const points = [];
  for (let i = 0; i < rows; i++) {
    // Rows lie closer at the root, where the flare is, and at the tip.
    const t = i / rows;
    const s = t * t * (0.6 * (1 - t) + 1) * 0.625 + 0.375 * t;
    const along = unit(arm(s + 1e-4).map((x, k) => x - arm(s - 1e-4)[k]));
    // The root is round; the membrane grows out of it, from finger to finger in bows.
    const spread = clamp((s - 0.02) / 0.16) ** 2 * (3 - 2 * clamp((s - 0.02) / 0.16));
    const bow = (FINGERS * s) % 1;
    const chord = 1.15 * (1 - s ** 2.2) ** 0.8 * (1 - 0.3 * Math.sin(Math.PI * bow) ** 0.8) + 0.02;
    const rib = 1 + 1.2 * Math.exp(-((Math.min(bow, 1 - bow) / 0.09) ** 2)) * Number(s > 0.2);
    const flare = ROOT * (1 + 1.1 * Math.exp(-s / 0.012)) * (1 - 0.45 * clamp(s / 0.2));
    const back = unit([0.55 * s * s, -0.15 - 0.5 * s, -1]);
    const up = unit(cross(along, back).map((x) => -x));
    const back2 = cross(along, up);
    for (let j = 0; j < around; j++) {
      const angle = (2 * Math.PI * j) / around;
      const u = (1 - Math.cos(angle)) / 2;
      const thick =
        Math.sin(angle) * (ARM * (1 - s) ** 0.7 * (1 - u) ** 3 * 1.9 + 0.011 * rib * (1 - 0.5 * s));
      const sheet = [-ARM * (1 - s) + u * chord, thick];
      const round = [-flare * Math.cos(angle), flare * Math.sin(angle)];
      const [c, w] = mix(round, sheet, spread);
      points.push(arm(s).map((x, k) => x + c * (spread * back[k] + (1 - spread) * back2[k]) + w * up[k]));
    }
  }
  points.push(arm(1));
  const triangles = [];
  for (let i = 0; i + 1 < rows; i++)
    for (let j = 0; j < around; j++) {
      const next = (j + 1) % around;
      triangles.push(
        ...halves(points, [i * around + j, i * around + next, (i + 1) * around + next, (i + 1) * around + j]),
      );
    }
  for (let j = 0; j < around; j++)
    triangles.push([(rows - 1) * around + j, (rows - 1) * around + ((j + 1) % around), rows * around]);
  return { points, triangles };
}

/** A pair of wings, each other's mirror image. */
function wings() {
  const left = wing();
  const count = left.points.length;
  return {
    points: [...left.points, ...left.points.map(([x, y, z]) => [-x, y, z])].map(([x, y, z], v) => [
      x + (v < count ? 0.3 : -0.3),
      y,
      z,
    ]),
    triangles: [...left.triangles, ...left.triangles.map(([a, b, c]) => [a + count, c + count, b + count])],
  };
}

/** A grid of points, made of two triangles a cell. @param place  of a row and a column, both from 0 to 1 */
function sheet(rows, columns, place) {
  const points = [];
  for (let i = 0; i <= rows; i++)
    for (let j = 0; j <= columns; j++) points.push(place(i / rows, j / columns));
  const triangles = [];
  for (let i = 0; i < rows; i++)
    for (let j = 0; j < columns; j++) {
      const at = i * (columns + 1) + j;
      triangles.push(...halves(points, [at, at + 1, at + columns + 2, at + columns + 1]));
    }
  return { points, triangles };
}

/** A band with half a turn in it: it has one side. Its ends meet in the same places, not in the same vertices. */
const moebius = () =>
  sheet(240, 20, (along, across) => {
    const angle = 2 * Math.PI * along;
    const [out, up] = [Math.cos(angle / 2), Math.sin(angle / 2)].map((x) => 0.6 * (across - 0.5) * x);
    return [(1 + out) * Math.cos(angle), up, (1 + out) * Math.sin(angle)];
  });

/** Three sheets that share one upright edge. */
function sheets() {
  const leaves = [90, 210, 330].map((degrees) => {
    const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
    return sheet(40, 40, (out, up) => [out * c, 1.2 * (up - 0.5), out * s]);
  });
  const points = [...leaves[0].points];
  const triangles = [...leaves[0].triangles];
  for (const leaf of leaves.slice(1)) {
    // The first row is the edge: it is there already.
    const shift = points.length - 41;
    points.push(...leaf.points.slice(41));
    triangles.push(...leaf.triangles.map((corners) => corners.map((v) => (v < 41 ? v : v + shift))));
  }
  return { points, triangles };
}

/** A cactus with ribs along its trunk and two arms, which grow out and turn upwards in a quarter circle. */
function cactus() {
  /** @param off  from the axis: at the rounded ends the ribs run out towards it */
  const ribbed = (far, angle, [radius, count], off) =>
    far - radius * (1 + 0.07 * clamp(off / radius) * Math.cos(count * angle));
  const trunk = ([x, y, z]) => {
    const far = Math.hypot(x, z, Math.max(0, y - 1.86));
    return Math.max(ribbed(far, Math.atan2(z, x), [0.25, 12], Math.hypot(x, z)), 0.028 - y);
  };
  const arm = ([x, y, z], { side, low, out, turn, high, radius }) => {
    const [a, cx, cy] = [side * x, out - turn, low + turn];
    // How far off the arm's axis, away from the centre of the turn.
    const w = a < cx ? low - y : y < cy ? Math.hypot(a - cx, y - cy) - turn : a - out;
    const far = Math.hypot(w, z, a >= cx ? Math.max(0, y - high) : Math.max(0, -a));
    return ribbed(far, Math.atan2(z, w), [radius, 8], Math.hypot(w, z));
  };
  return implicitSurface({
    low: [-0.812, 0, -0.336],
    high: [0.924, 2.184, 0.336],
    cell: 0.028,
    inside: (...p) =>
      blend(
        0.09,
        trunk(p),
        arm(p, { side: 1, low: 0.8, out: 0.7, turn: 0.28, high: 1.5, radius: 0.125 }),
        arm(p, { side: -1, low: 1.08, out: 0.6, turn: 0.25, high: 1.64, radius: 0.112 }),
      ),
  });
}

/** A snake along x, its head to the front, cut across in two: both pieces are closed. */
function snake() {
  const [tail, head] = [-2.1, 1.75];
  return implicitSurface({
    low: [-2.275, -0.315, -0.315],
    high: [2.31, 0.315, 0.315],
    cell: 0.035,
    inside: (...p) => {
      const [x, y, z] = p;
      const t = clamp((x - tail) / (head - tail));
      const radius = 0.05 + 0.17 * Math.min(1, t / 0.6) ** 0.8 - 0.07 * clamp((t - 0.7) / 0.3) ** 2;
      const body = 0.9 * (Math.hypot(x - tail - t * (head - tail), y, z) - radius);
      const skull = Math.hypot((x - 1.88) / 1.45, y / 0.72, z) - 0.22;
      const eye = Math.hypot(x - 1.98, y - 0.11, Math.abs(z) - 0.15) - 0.055;
      const whole = blend(0.02, blend(0.15, body, 0.8 * skull), eye);
      return -blend(0.04, -whole, Math.abs(x - 0.6) - 0.08);
    },
  });
}

/** What goes round an upright axis: at each angle the same closed profile, seen from outside counter-clockwise. */
function ring(around, profile) {
  const points = [];
  const rows = [];
  for (let i = 0; i < around; i++) {
    const angle = (2 * Math.PI * i) / around;
    const places = profile(angle, i);
    rows.push(places.length);
    for (const [out, up] of places) points.push([out * Math.cos(angle), up, out * Math.sin(angle)]);
  }
  const [count] = rows;
  const triangles = [];
  for (let i = 0; i < around; i++)
    for (let j = 0; j < count; j++) {
      const [a, b] = [i * count, ((i + 1) % around) * count];
      const next = (j + 1) % count;
      triangles.push(...halves(points, [a + j, a + next, b + next, b + j]));
    }
  return { points, triangles };
}

const torus = () =>
  ring(80, () =>
    Array.from({ length: 40 }, (_, j) => {
      const turn = (2 * Math.PI * j) / 40;
      return [0.7 + 0.3 * Math.cos(turn), 0.3 * Math.sin(turn)];
    }),
  );

/** A hexagonal nut without thread: every edge is sharp. */
function nut() {
  const [FLAT, HOLE, HALF] = [0.87, 0.5, 0.36];
  const between = (a, b, count) => Array.from({ length: count }, (_, j) => mix(a, b, j / count));
  return ring(96, (angle) => {
    // Distance to the flat side that is nearest.
    const off = ((angle + Math.PI / 6) % (Math.PI / 3)) - Math.PI / 6;
    const side = FLAT / Math.cos(off);
    const corners = [
      [side, -HALF],
      [side, HALF],
      [HOLE, HALF],
      [HOLE, -HALF],
    ];
    return corners.flatMap((corner, k) => between(corner, corners[(k + 1) % 4], k % 2 ? 8 : 14));
  });
}

/** An egg: an octahedron whose sides are cut in `count`, blown up, stretched, turned about z and moved. */
function ellipsoid([cx, cy, cz], radii, turn = 0, count = 24) {
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  const numbers = new Map();
  const points = [];
  const vertex = (corner) => {
    const key = corner.join();
    if (!numbers.has(key)) {
      numbers.set(key, points.length);
      // Even on the sphere: equal steps along a side are equal angles.
      const [x, y, z] = unit(corner.map((k) => Math.sin((Math.PI / 2) * (k / count)))).map(
        (k, i) => k * radii[i],
      );
      points.push([cx + c * x - s * y, cy + s * x + c * y, cz + z]);
    }
    return numbers.get(key);
  };
  const triangles = [];
  for (const [sx, sy, sz] of [0, 1, 2, 3, 4, 5, 6, 7].map((bits) =>
    [1, 2, 4].map((bit) => (bits & bit ? -1 : 1)),
  ))
    for (let i = 0; i < count; i++)
      for (let j = 0; i + j < count; j++) {
        const at = (a, b) => vertex([sx * a || 0, sy * b || 0, sz * (count - a - b) || 0]);
        const two = [[at(i, j), at(i + 1, j), at(i, j + 1)]];
        if (i + j + 1 < count) two.push([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
        triangles.push(...(sx * sy * sz > 0 ? two : two.map(([a, b, d]) => [a, d, b])));
      }
  return { points, triangles };
}

/** A toy bear of seven eggs that reach into one another, each closed by itself: belly, head, ears, legs, and one for both arms. */
function bear() {
  const eggs = [
    ellipsoid([0, 0.62, 0], [0.34, 0.42, 0.3], 0, 30),
    ellipsoid([0, 1.22, 0.03], [0.3, 0.28, 0.29], 0, 26),
    ...[1, -1].map((side) => ellipsoid([side * 0.19, 1.46, 0.02], [0.12, 0.14, 0.08], -0.3 * side, 14)),
    ellipsoid([0, 0.78, 0.08], [0.64, 0.14, 0.14], 0, 26),
    ...[1, -1].map((side) => ellipsoid([side * 0.2, 0.25, 0.14], [0.16, 0.17, 0.32], 0, 18)),
  ];
  const points = [];
  const triangles = [];
  for (const egg of eggs) {
    triangles.push(...egg.triangles.map((corners) => corners.map((v) => v + points.length)));
    points.push(...egg.points);
  }
  return { points, triangles };
}

/** A rabbit that sits like the bear does, in one piece. */
function rabbit() {
  return implicitSurface({
    low: [-0.792, -0.024, -0.48],
    high: [0.792, 2.112, 0.576],
    cell: 0.03,
    inside: (...p) => {
      const [x, y, z] = p;
      const q = [Math.abs(x), y, z];
      const egg = ([cx, cy, cz], [rx, ry, rz]) => {
        const least = Math.min(rx, ry, rz);
        return (Math.hypot((q[0] - cx) / rx, (y - cy) / ry, (z - cz) / rz) - 1) * least;
      };
      const trunk = egg([0, 0.55, -0.02], [0.33, 0.42, 0.31]);
      const head = egg([0, 1.15, 0.07], [0.25, 0.25, 0.27]);
      const snout = Math.hypot(q[0] - 0.05, y - 1.08, z - 0.29) - 0.09;
      const ear = capsule(q, [0.1, 1.3, 0.02], [0.2, 1.92, -0.06], 0.085);
      const arm = capsule(q, [0.25, 0.78, 0.12], [0.5, 0.62, 0.22], 0.085);
      const leg = capsule(q, [0.21, 0.14, 0.06], [0.22, 0.12, 0.4], 0.12);
      const scut = Math.hypot(x, y - 0.3, z + 0.34) - 0.1;
      return blend(0.06, blend(0.12, trunk, head), snout, ear, arm, leg, scut);
    },
  });
}

const shoe = () => shoeOf('foot-female');
const bodySoup = () => soupOf('body-male', 'body-female');
const bodyPoints = () => pointsOf('body-heavy');

const shapes = {
  pipes,
  block,
  key,
  wings,
  loops,
  moebius,
  sheets,
  cactus,
  snake,
  shoe,
  torus,
  nut,
  bear,
  rabbit,
  'body-soup': bodySoup,
  'body-points': bodyPoints,
};
const wanted = process.argv.slice(2);
for (const [name, shape] of Object.entries(shapes)) {
  if (wanted.length > 0 && !wanted.includes(name)) continue;
  const mesh = await shape();
  writeFileSync(new URL(`${name}.ply`, folder), plyOf(mesh));
  console.log(name, mesh.points.length, 'vertices');
}
