// The gallery's models bent by the isoline method: a large one, one with holes, the bar by three bases, and a face.

import { barHandles } from './deform.mjs';
import { faceHandles, SMILE, SORROW } from './face.mjs';
import { after, deformRecipe, pick, region, turn } from './handles.mjs';
import { modelOf } from './models.mjs';

const byIsolines = (model, handles, options = {}) =>
  deformRecipe(model, 'all', handles, { method: 'isolines', options });

/** Close on half a million vertices, by four handles. */
function critterDancing() {
  const { points } = modelOf('critter-scaled');
  const held = (name, inside, matrix) => region(name, pick(points, inside), matrix);
  const lean = turn([0, 0, 1], -8, [0, 0.5, 0]);
  return byIsolines('critter-scaled', [
    held('Legs', (_x, y) => y < 0.5),
    held('Head', (_x, y) => y > 1.95, after(lean, turn([0.2, 1, 0.25], 25, [0, 1.8, 0]))),
    held(
      'Left hand',
      (x, y) => x > 0.86 && y > 0.95,
      after(lean, turn([0.2, 0.4, 1], 50, [0.4, 1.36, 0.06])),
    ),
    held(
      'Right hand',
      (x, y) => x < -0.86 && y > 0.95,
      after(lean, turn([0.3, -0.5, 1], 20, [-0.4, 1.36, 0.06])),
    ),
  ]);
}

function loopsRearing() {
  const { points } = modelOf('loops');
  const held = (name, inside, matrix) => region(name, pick(points, inside), matrix);
  return byIsolines('loops', [
    held('Rear feet', (x, y) => x < -0.9 && y < 0.2),
    held('Head', (x) => x > 1.6, turn([0, 0.2, 1], 65, [-0.2, 0.7, 0])),
  ]);
}

const barTwisted = (options) => byIsolines('bar', barHandles(), options);

const face = (moves) => byIsolines('head-female', faceHandles(moves));

/** @returns name, title, model and recipe of each example */
export function isolineExamples() {
  return [
    ['critter-scaled-dancing', 'Critter of 476,000 vertices', 'critter-scaled', critterDancing()],
    ['loops-rearing', 'Loops, rearing', 'loops', loopsRearing()],
    ['bar-by-isolines', 'Bar, twisted by isolines', 'bar', barTwisted()],
    ['bar-by-10-hats', 'Bar, 10 straight controls', 'bar', barTwisted({ isolines: 10, basis: 'hats' })],
    ['bar-by-20-hats', 'Bar, 20 straight controls', 'bar', barTwisted({ isolines: 20, basis: 'hats' })],
    ['face-happy', 'Face, happy', 'head-female', face(SMILE)],
    ['face-sad', 'Face, sad', 'head-female', face(SORROW)],
  ];
}
