// Distances from simple shapes, below 0 inside, and what is made of several: models by formula are put together from them.

export const clamp = (x, low = 0, high = 1) => Math.min(high, Math.max(low, x));
/** The union of two shapes with a fillet of about k between them (Quilez' polynomial smooth minimum). */
export const blend = (k, ...distances) =>
  distances.reduce((a, b) => {
    const h = Math.max(k - Math.abs(a - b), 0) / k;
    return Math.min(a, b) - (h * h * k) / 4;
  });
export const capsule = ([x, y, z], [ax, ay, az], [bx, by, bz], radius) => {
  const [dx, dy, dz] = [bx - ax, by - ay, bz - az];
  const t = clamp(((x - ax) * dx + (y - ay) * dy + (z - az) * dz) / (dx * dx + dy * dy + dz * dz));
  return Math.hypot(x - ax - t * dx, y - ay - t * dy, z - az - t * dz) - radius;
};
export const box = ([x, y, z], [cx, cy, cz], half, rounding) => {
  const q = [Math.abs(x - cx), Math.abs(y - cy), Math.abs(z - cz)].map((d, k) => d - half[k] + rounding);
  const out = Math.hypot(...q.map((d) => Math.max(d, 0)));
  return out + Math.min(Math.max(...q), 0) - rounding;
};
/** A cylinder along `axis` (0 = x, 1 = y, 2 = z) from `from` to `to`, its rims rounded. */
export const cylinder = (p, axis, [c1, c2], from, to, radius, rounding) => {
  const r = Math.hypot(p[(axis + 1) % 3] - c1, p[(axis + 2) % 3] - c2) - radius + rounding;
  const h = Math.abs(p[axis] - (from + to) / 2) - (to - from) / 2 + rounding;
  return Math.hypot(Math.max(r, 0), Math.max(h, 0)) + Math.min(Math.max(r, h), 0) - rounding;
};
