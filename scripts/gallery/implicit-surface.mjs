// Triangles of a surface given by a formula: one vertex in each cell of a grid that the surface passes through (naive
// surface nets, Gibson 1998), drawn onto the surface and evened out along it. Where the grid ends, or where the
// caller says, the surface is open, and its edge is drawn onto a plane.

const EVENING = 24; // rounds; more change nothing one could see
const AXES = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/**
 * @param inside  (x, y, z) → below 0 inside; near the surface about the distance from it
 * @param low,high  corners of the box looked at; multiples of `cell`
 * @param cell  edge of the grid's cells: about that of the triangles
 * @param opening  (x, y, z) → undefined, or the height y at which the surface ends there; nothing is made above it
 *   (or below it, where `downward`)
 * @returns points and triangles, those facing out counter-clockwise
 */
export function implicitSurface({ inside, low, high, cell, opening = () => undefined, downward = false }) {
  const count = low.map((l, k) => Math.round((high[k] - l) / cell));
  const [nx, ny, nz] = count;
  const at = (i, j, k) => low.map((l, axis) => l + cell * [i, j, k][axis]);
  const corner = (i, j, k) => (k * (ny + 1) + j) * (nx + 1) + i;
  const value = new Float64Array((nx + 1) * (ny + 1) * (nz + 1));
  for (let k = 0; k <= nz; k++)
    for (let j = 0; j <= ny; j++)
      for (let i = 0; i <= nx; i++) value[corner(i, j, k)] = inside(...at(i, j, k));

  const points = [];
  const vertex = new Map();
  const cellAt = (i, j, k) => (k * ny + j) * nx + i;
  for (let k = 0; k < nz; k++)
    for (let j = 0; j < ny; j++)
      for (let i = 0; i < nx; i++) {
        const middle = at(i + 0.5, j + 0.5, k + 0.5);
        const end = opening(...middle);
        if (end !== undefined && (downward ? middle[1] < end : middle[1] > end)) continue;
        const crossings = [];
        for (const [axis, step] of AXES.entries())
          for (let c = 0; c < 4; c++) {
            const from = [i, j, k];
            from[(axis + 1) % 3] += c & 1;
            from[(axis + 2) % 3] += c >> 1;
            const a = value[corner(...from)];
            const b = value[corner(...from.map((x, d) => x + step[d]))];
            if (a < 0 === b < 0) continue;
            const p = at(...from);
            p[axis] += (cell * a) / (a - b);
            crossings.push(p);
          }
        if (crossings.length === 0) continue;
        vertex.set(cellAt(i, j, k), points.length);
        points.push([0, 1, 2].map((d) => crossings.reduce((sum, p) => sum + p[d], 0) / crossings.length));
      }

  const quads = [];
  for (let k = 0; k <= nz; k++)
    for (let j = 0; j <= ny; j++)
      for (let i = 0; i <= nx; i++)
        for (const [axis, step] of AXES.entries()) {
          const to = [i + step[0], j + step[1], k + step[2]];
          if (to[0] > nx || to[1] > ny || to[2] > nz) continue;
          const a = value[corner(i, j, k)];
          const b = value[corner(...to)];
          if (a < 0 === b < 0) continue;
          const around = [0, 1, 3, 2].map((c) => {
            const place = [i, j, k];
            place[(axis + 1) % 3] -= c & 1;
            place[(axis + 2) % 3] -= c >> 1;
            return place.every((x, d) => x >= 0 && x < count[d]) ? vertex.get(cellAt(...place)) : undefined;
          });
          if (around.includes(undefined)) continue;
          quads.push(a < 0 ? around : [...around].reverse());
        }
  const mesh = { points, triangles: quads.flatMap((quad) => halves(points, quad)) };
  even(mesh, inside, cell, opening);
  return withoutLoose({ points, triangles: quads.flatMap((quad) => halves(points, quad)) });
}

/** Two triangles of a quad, along its shorter diagonal. */
export function halves(points, [a, b, c, d]) {
  const far = (p, q) => Math.hypot(...points[p].map((x, k) => x - points[q][k]));
  return far(a, c) <= far(b, d)
    ? [
        [a, b, c],
        [a, c, d],
      ]
    : [
        [a, b, d],
        [b, c, d],
      ];
}

/** Moves each vertex to the middle of its neighbours and back onto the surface; the edge stays on its plane. */
function even({ points, triangles }, inside, cell, opening) {
  const neighbours = points.map(() => new Map());
  for (const triangle of triangles)
    for (let c = 0; c < 3; c++) {
      const [a, b] = [triangle[c], triangle[(c + 1) % 3]];
      for (const [p, q] of [
        [a, b],
        [b, a],
      ])
        neighbours[p].set(q, (neighbours[p].get(q) ?? 0) + 1);
    }
  const edge = neighbours.map((around) => [...around].filter(([, faces]) => faces === 1).map(([v]) => v));
  const gradient = ([x, y, z]) => {
    const h = cell / 16;
    return [
      inside(x + h, y, z) - inside(x - h, y, z),
      inside(x, y + h, z) - inside(x, y - h, z),
      inside(x, y, z + h) - inside(x, y, z - h),
    ].map((d) => d / (2 * h));
  };
  const onto = (v, point) => {
    const p = [...point];
    const end = edge[v].length > 0 ? opening(...p) : undefined;
    for (let step = 0; step < 4; step++) {
      if (end !== undefined) p[1] = end;
      const g = gradient(p);
      if (end !== undefined) g[1] = 0;
      const size = g.reduce((sum, d) => sum + d * d, 0);
      if (!(size > 1e-12)) break;
      const far = Math.max(-cell / 2, Math.min(cell / 2, inside(...p) / Math.sqrt(size))) / Math.sqrt(size);
      for (let d = 0; d < 3; d++) p[d] -= far * g[d];
    }
    return p;
  };
  for (let round = 0; round < EVENING; round++) {
    const next = points.map((point, v) => {
      const around = edge[v].length > 0 ? edge[v] : [...neighbours[v].keys()];
      if (around.length === 0) return point;
      const middle = point.map((_, d) => around.reduce((sum, w) => sum + points[w][d], 0) / around.length);
      return onto(
        v,
        point.map((x, d) => 0.5 * (x + middle[d])),
      );
    });
    for (const [v, point] of next.entries()) points[v] = point;
  }
}

function withoutLoose({ points, triangles }) {
  const used = new Set(triangles.flat());
  const number = new Map([...points.keys()].filter((v) => used.has(v)).map((v, place) => [v, place]));
  return {
    points: points.filter((_, v) => used.has(v)),
    triangles: triangles.map((triangle) => triangle.map((v) => number.get(v))),
  };
}
