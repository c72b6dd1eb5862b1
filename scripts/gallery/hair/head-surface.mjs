// A head's skin for scripts that place strokes on it: rays from outside towards its middle.

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const along = (a, b, t) => [a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]];
export const unit = (a) => {
  const length = Math.hypot(...a);
  return a.map((x) => x / length);
};

/** Degrees round the upward axis from the face (0) by its left ear (90) to the back (180), and upwards. */
export function towards(azimuth, elevation) {
  const [a, e] = [(azimuth * Math.PI) / 180, (elevation * Math.PI) / 180];
  return [Math.cos(e) * Math.sin(a), Math.sin(e), Math.cos(e) * Math.cos(a)];
}

/** Between two directions by the shortest way, evenly. */
export function slerp(a, b, t) {
  const angle = Math.acos(Math.min(1, Math.max(-1, dot(a, b))));
  if (angle < 1e-6) return a;
  const [p, q] = [Math.sin((1 - t) * angle), Math.sin(t * angle)].map((s) => s / Math.sin(angle));
  return [0, 1, 2].map((k) => p * a[k] + q * b[k]);
}

export class HeadSurface {
  /** @param head  as `readPly` gives it, of triangles */
  constructor({ points, faces, scalp }) {
    this.points = points;
    /** Vertices that hair grows on. */
    this.scalp = scalp;
    this.triangles = faces;
    const roots = scalp.map((v) => points[v]);
    const range = (points, k) => {
      const values = points.map((p) => p[k]);
      return [values.reduce((a, b) => Math.min(a, b)), values.reduce((a, b) => Math.max(a, b))];
    };
    const [low, high] = range(this.points, 1);
    this.height = high - low;
    const middle = (k) => range(roots, k).reduce((a, b) => a + b) / 2;
    this.centre = [0, middle(1), middle(2)];
  }

  /** Where the skin is, seen from the middle in a direction, and its normal. The outermost hit counts. */
  at(direction) {
    const d = unit(direction);
    let best = { distance: 0, point: this.centre, normal: d };
    for (const [i, j, k] of this.triangles) {
      const [a, b, c] = [this.points[i], this.points[j], this.points[k]];
      const [u, v] = [minus(b, a), minus(c, a)];
      const p = cross(d, v);
      const determinant = dot(u, p);
      if (Math.abs(determinant) < 1e-18) continue;
      const to = minus(this.centre, a);
      const s = dot(to, p) / determinant;
      if (s < 0 || s > 1) continue;
      const q = cross(to, u);
      const t = dot(d, q) / determinant;
      if (t < 0 || s + t > 1) continue;
      const distance = dot(v, q) / determinant;
      if (distance > best.distance)
        best = { distance, point: along(this.centre, d, distance), normal: unit(cross(u, v)) };
    }
    return best;
  }
}
