// The gallery's blends: heads, a nose, bodies by their measures. Parts and tapes are picked on the skins that the match
// leaves. Written by scripts/gallery.mjs.

import { BODY, builtIn, HEAD, matchOf, NOSE_TIP } from './landmarks.mjs';
import { modelOf } from './models.mjs';
import { skinsOf } from './skins.mjs';
import { setOf } from './vertex-set.mjs';

/** Of skins of heads, metres: fine enough for a nose, and matched in seconds. */
const HEAD_EDGE = 0.006;
const BODY_EDGE = 0.017;
const UP = [0, 1, 0];

const heads = ['head-female', 'head-male', 'head-elf'];
export const bodies = ['body-female', 'body-male', 'body-heavy'];
export const bodyMatch = () => matchOf(bodies, BODY, { edgeLength: BODY_EDGE });

const blendStep = (more) => ({
  id: 'blend 1',
  type: 'blend',
  match: 'match 1',
  parts: [],
  measures: [],
  ...more,
});

const recipe = (models, match, blend) => ({
  lissom: 1,
  models: builtIn(...models),
  steps: [match, blendStep(blend)],
  outputs: [],
});

const triangle = () =>
  recipe(heads, matchOf(heads, HEAD, { edgeLength: HEAD_EDGE }), {
    weights: { 'head-female': 0.4, 'head-male': 0.3, 'head-elf': 0.3 },
  });

/** An elf's nose in a woman's face. */
async function nose() {
  const pair = ['head-female', 'head-elf'];
  const match = matchOf(pair, HEAD, { edgeLength: HEAD_EDGE });
  const { skins } = await skinsOf(builtIn(...pair), match);
  const { positions } = skins['head-female'];
  const [x, y, z] = modelOf('head-female').points[NOSE_TIP];
  // An egg about the nose: from between the eyes to the lip.
  const inside = (p) =>
    Math.hypot((p[0] - x) / 0.021, (p[1] - y - 0.012) / 0.029, (p[2] - z + 0.006) / 0.03) < 1;
  const vertices = Array.from({ length: positions.length / 3 }, (_, v) => v).filter((v) =>
    inside(positions.subarray(3 * v, 3 * v + 3)),
  );
  return recipe(pair, match, {
    weights: { 'head-female': 1, 'head-elf': 0 },
    parts: [{ name: 'Nose', from: 'head-elf', vertices: setOf(vertices), feather: 0.012, how: 'paste' }],
  });
}

/** A body as tall and as wide as it is asked to be. */
async function measured() {
  const match = bodyMatch();
  const { levels } = await skinsOf(builtIn(...bodies), match);
  const girth = (name, preset, more) => ({
    kind: 'girth',
    name,
    vertex: levels.preset(preset),
    normal: UP,
    hull: true,
    ...more,
  });
  return recipe(bodies, match, {
    weights: Object.fromEntries(bodies.map((name) => [name, 1 / 3])),
    measures: [
      { kind: 'height', name: 'Height', up: UP, value: 1.7 },
      girth('Chest', 'chest'),
      girth('Waist', 'waist', { value: 0.8 }),
      girth('Hips', 'hip'),
    ],
  });
}

/** @returns name, title, model and recipe of each example */
export async function blendExamples() {
  return [
    ['blend-heads', 'Three heads', 'head-female', triangle()],
    ['blend-nose', 'An elf’s nose', 'head-female', await nose()],
    ['blend-bodies', 'A body to measure', 'body-female', await measured()],
  ];
}
