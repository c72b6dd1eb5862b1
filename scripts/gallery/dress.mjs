// The gallery's clothes and shoes on people they were not made for. Written by scripts/gallery.mjs.

import { bodies, bodyMatch } from './blend.mjs';
import { builtIn, FOOT, matchOf } from './landmarks.mjs';

const [FEMALE, MALE, HEAVY] = bodies;
/** Metres: of what is worn over something else. */
const OVER = 0.006;
const FOOT_EDGE = 0.007;

const feet = ['foot-female', 'foot-male', 'foot-child'];

const worn = (number, garment, from, to, offset = 0) => ({
  id: `dress ${number}`,
  type: 'dress',
  garment,
  match: 'match 1',
  from,
  to,
  offset,
});

const recipe = (match, ...steps) => ({
  lissom: 1,
  models: builtIn(...new Set([...match.models, ...steps.map(({ garment }) => garment)])),
  steps: [match, ...steps],
  outputs: [],
});

/** @returns name, title, model and recipe of each example */
export function dressExamples() {
  return [
    [
      'dress-man',
      'Shirt and pants, a man',
      'shirt',
      recipe(bodyMatch(), worn(1, 'pants', FEMALE, MALE), worn(2, 'shirt', FEMALE, MALE, OVER)),
    ],
    [
      'dress-heavy',
      'Shirt and skirt, another size',
      'skirt',
      recipe(bodyMatch(), worn(1, 'shirt', FEMALE, HEAVY), worn(2, 'skirt', FEMALE, HEAVY, OVER)),
    ],
    [
      'dress-shoe',
      'A shoe on two feet',
      'shoe',
      recipe(
        matchOf(feet, FOOT, { edgeLength: FOOT_EDGE }),
        worn(1, 'shoe', feet[0], feet[2]),
        worn(2, 'shoe', feet[0], feet[1]),
      ),
    ],
  ];
}
