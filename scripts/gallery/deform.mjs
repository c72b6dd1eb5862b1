// The gallery's bent models: what may move and what is taken hold of is picked by geometry, as a hand would paint it.

import { identity, pick, deformRecipe as recipe, region, turn } from './handles.mjs';
import { modelOf } from './models.mjs';

function dinosaur(head = identity, tail = identity) {
  const { points } = modelOf('dinosaur');
  const isNeck = (y, z) => (y - 1.12) * 0.64 + (z - 0.62) * 0.77 > 0;
  return recipe(
    'dinosaur',
    pick(points, (_, y, z) => isNeck(y, z) || z < -0.85),
    [
      region(
        'Head',
        pick(points, (_, y, z) => y > 2.06 && z > 1.2),
        head,
      ),
      region(
        'Tail',
        pick(points, (_x, _y, z) => z < -2.4),
        tail,
      ),
    ],
  );
}

function critter() {
  const { points } = modelOf('critter');
  return recipe(
    'critter',
    pick(points, (x, y) => Math.abs(x) > 0.42 && y > 0.95 && y < 1.75),
    [
      region(
        'Left hand',
        pick(points, (x, y) => x > 0.86 && y > 0.95),
        turn([0, 0, 1], 62, [0.4, 1.36, 0.06]),
      ),
      region(
        'Right hand',
        pick(points, (x, y) => x < -0.86 && y > 0.95),
        turn([0, 0, 1], 48, [-0.4, 1.36, 0.06]),
      ),
    ],
  );
}

/** The bar held at its foot, its top turned. */
export function barHandles() {
  const { points } = modelOf('bar');
  const ys = points.map(([, y]) => y);
  const [low, high] = [ys.reduce((a, b) => Math.min(a, b)), ys.reduce((a, b) => Math.max(a, b))];
  const end = (high - low) * 0.08;
  return [
    region(
      'Foot',
      pick(points, (_, y) => y < low + end),
    ),
    region(
      'Top',
      pick(points, (_, y) => y > high - end),
      turn([0, 1, 0], 150, [0, high, 0]),
    ),
  ];
}

const bar = () => recipe('bar', 'all', barHandles());

function octopus() {
  const { points } = modelOf('octopus');
  const radius = (x, z) => Math.hypot(x, z);
  const ends = [
    [1.447, 0.089],
    [0.823, 1.194],
    [-0.859, 1.168],
    [-1.373, 0.466],
    [-1.447, -0.099],
    [-0.626, -1.308],
    [0.532, -1.349],
    [1.141, -0.895],
  ];
  const handles = ends.map(([ex, ez], arm) => {
    const length = Math.hypot(ex, ez);
    const near = (x, z) => (x * ex + z * ez) / length > length - 0.3 && Math.hypot(x - ex, z - ez) < 0.42;
    // About the horizontal axis across the arm: up and inwards.
    const axis = [ez / length, 0, -ex / length];
    const knee = [(ex / length) * 0.95, 0.12, (ez / length) * 0.95];
    return region(
      `Arm ${arm + 1}`,
      pick(points, (x, _, z) => near(x, z)),
      turn(axis, -95, knee),
    );
  });
  return recipe(
    'octopus',
    pick(points, (x, y, z) => y < 0.45 && radius(x, z) > 0.42),
    handles,
  );
}

/** What the app opens with: its first model at rest, with two handles. */
export const firstRecipe = () => dinosaur();

/** @returns name, title, model and recipe of each example */
export function deformExamples() {
  const [back, up] = [turn([0, 1, 0.2], 100, [0, 1.5, 0.95]), turn([1, 0.3, 0], 55, [0, 0.75, -1.3])];
  return [
    ['dinosaur-looking-back', 'Dinosaur, looking back', 'dinosaur', dinosaur(back, up)],
    ['critter-waving', 'Critter, waving', 'critter', critter()],
    ['bar-twisted', 'Bar, twisted', 'bar', bar()],
    ['octopus-curled', 'Octopus, curled up', 'octopus', octopus()],
  ];
}
