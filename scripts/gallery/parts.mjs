// The gallery's parts: models made to be merged with others, by formula. Writes public/gallery/<name>.ply. Run by hand
// when a shape changes, and scripts/gallery.mjs after it: node scripts/gallery/parts.mjs

import { writeFileSync } from 'node:fs';
import { halves, implicitSurface } from './implicit-surface.mjs';
import { folder } from './models.mjs';
import { plyOf } from './ply.mjs';

const clamp = (x, low = 0, high = 1) => Math.min(high, Math.max(low, x));
/** The union of two shapes with a fillet of about k between them (Quilez' polynomial smooth minimum). */
const blend = (k, ...distances) =>
  distances.reduce((a, b) => {
    const h = Math.max(k - Math.abs(a - b), 0) / k;
    return Math.min(a, b) - (h * h * k) / 4;
  });
const capsule = ([x, y, z], [ax, ay, az], [bx, by, bz], radius) => {
  const [dx, dy, dz] = [bx - ax, by - ay, bz - az];
  const t = clamp(((x - ax) * dx + (y - ay) * dy + (z - az) * dz) / (dx * dx + dy * dy + dz * dz));
  return Math.hypot(x - ax - t * dx, y - ay - t * dy, z - az - t * dz) - radius;
};
const box = ([x, y, z], [cx, cy, cz], half, rounding) => {
  const q = [Math.abs(x - cx), Math.abs(y - cy), Math.abs(z - cz)].map((d, k) => d - half[k] + rounding);
  const out = Math.hypot(...q.map((d) => Math.max(d, 0)));
  return out + Math.min(Math.max(...q), 0) - rounding;
};
/** A cylinder along `axis` (0 = x, 1 = y, 2 = z) from `from` to `to`, its rims rounded. */
const cylinder = (p, axis, [c1, c2], from, to, radius, rounding) => {
  const r = Math.hypot(p[(axis + 1) % 3] - c1, p[(axis + 2) % 3] - c2) - radius + rounding;
  const h = Math.abs(p[axis] - (from + to) / 2) - (to - from) / 2 + rounding;
  return Math.hypot(Math.max(r, 0), Math.max(h, 0)) + Math.min(Math.max(r, h), 0) - rounding;
};

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

const write = (name, mesh) => {
  writeFileSync(new URL(`${name}.ply`, folder), plyOf(mesh));
  console.log(name, mesh.points.length, 'vertices');
};
write('pipes', pipes());
write('block', block());
write('key', key());
write('wings', wings());
