// Heads: an elf's ears by curves inside them, a brow by the line that is seen there.

import { openSources } from '../../lib/sources.mjs';
import { pick } from '../handles.mjs';
import { modelOf } from '../models.mjs';
import { curve, curvesRecipe, evenly, minus, plus } from './chains.mjs';

const mirrored = (points) => points.map(([x, y, z]) => [-x, y, z]);
const [ROOT, TIP] = [
  [0.083, 0.195, 0.045],
  [0.0905, 0.2165, 0.0255],
];

/** The tips of both ears drawn out, up and backwards. */
export function ears() {
  const { points } = modelOf('head-elf');
  const along = minus(TIP, ROOT);
  const tip = (x, y, z) => {
    const ahead = minus([x, y, z], ROOT).reduce((sum, d, k) => sum + d * along[k], 0) > 0;
    return ahead && x > 0.082 && z > 0.015 && z < 0.056;
  };
  // On from where the ear points to, then bending back.
  const [before, after] = [plus(ROOT, along, 1.5), [0.118, 0.262, -0.022]];
  const arc = Array.from({ length: 13 }, (_, k) => {
    const t = k / 12;
    return ROOT.map((x, c) => (1 - t) ** 2 * x + 2 * t * (1 - t) * before[c] + t * t * after[c]);
  });
  const ear = (id, side) => {
    const of = (list) => (side > 0 ? list : mirrored(list));
    return curve(id, of(evenly([ROOT, TIP], 6)), {
      posed: of(evenly(arc, 6)),
      region: pick(points, (x, y, z) => tip(side * x, y, z)),
      anchor: 'start',
    });
  };
  return curvesRecipe('head-elf', [ear('left ear', 1), ear('right ear', -1)]);
}

/** From the front, a little from above. */
const VIEW = { perspective: false, eye: [0, 0.1, 1] };
/** Where the left brow is, in the plane of the face. */
const onBrow = ([x, y]) => x > 0.012 && x < 0.056 && y > 0.1685 && y < 0.2;
/** From its inner end to the outer one. */
const LIFT = [0.0015, 0.003, 0.0045, 0.0055, 0.0058, 0.0055, 0.0045];

/** The left brow taken by its suggestive contour, and raised. */
export async function brow() {
  const line = (await linesSeen('head-female', VIEW))
    .map(stretchOnBrow)
    .reduce((a, b) => (lengthOf(b) > lengthOf(a) ? b : a));
  const rest = evenly(line[0][0] < line.at(-1)[0] ? line : line.toReversed(), LIFT.length);
  const posed = rest.map((point, k) => plus(point, [0, LIFT[k], 0.3 * LIFT[k]]));
  return curvesRecipe('head-female', [curve('left brow', rest, { posed }, 'contour')]);
}

/** The suggestive contours of a view, as the kernel finds them. */
async function linesSeen(model, view) {
  const server = await openSources();
  try {
    const { loadKernel } = await server.ssrLoadModule('/web/kernel/node.ts');
    const kernel = await loadKernel();
    const { points, faces } = modelOf(model);
    const { id } = await kernel.call('openModel', {
      positions: Float64Array.from(points.flat()),
      faceOffsets: Uint32Array.from({ length: faces.length + 1 }, (_, f) => 3 * f),
      faceVertices: Uint32Array.from(faces.flat()),
    });
    const { id: contours } = await kernel.call('prepareContours', { model: id });
    const seen = await kernel.call('contourLines', { contours, view });
    return [...seen.suggestive.keys()]
      .filter((line) => seen.suggestive[line] === 1)
      .map((line) =>
        Array.from({ length: seen.offsets[line + 1] - seen.offsets[line] }, (_, k) => {
          const at = 3 * (seen.offsets[line] + k);
          return [...seen.points.subarray(at, at + 3)];
        }),
      );
  } finally {
    await server.close();
  }
}

const lengthOf = (line) =>
  line.reduce((sum, p, k) => sum + (k ? Math.hypot(...p.map((x, c) => x - line[k - 1][c])) : 0), 0);

/** The longest stretch of a line on the brow. */
function stretchOnBrow(line) {
  const stretches = [[]];
  for (const point of line)
    if (onBrow(point)) stretches.at(-1).push(point);
    else stretches.push([]);
  return stretches.reduce((a, b) => (lengthOf(b) > lengthOf(a) ? b : a));
}
