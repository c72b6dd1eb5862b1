// The gallery's clothes and shoes on people they were not made for. Written by scripts/gallery.mjs.

import { bodies, bodyMatch } from './blend.mjs';
import { BODY, builtIn, FOOT, matchOf } from './landmarks.mjs';
import { modelOf } from './models.mjs';

const [FEMALE, MALE, HEAVY] = bodies;
/** Metres: of what is worn over something else. */
const OVER = 0.006;
/** A shirt that hangs over the band of a skirt. */
const OVER_BAND = 0.012;
/** Of skins that only clothes are carried by. */
const SCAN_EDGE = 0.022;
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

/** What the soup and the points were made of (scripts/gallery/scans.mjs), whose vertices are known. */
const SCANS = { 'body-soup': MALE, 'body-points': HEAVY };

/** One wardrobe on a soup and on points: their markers are places, for no vertex of theirs is where one of the source is. */
function figure() {
  const millimetres = (x) => Math.round(1000 * x) / 1000;
  const place = (vertex) => (of) => ({ point: modelOf(of).points[vertex].map(millimetres) });
  const match = {
    ...matchOf([FEMALE, ...Object.keys(SCANS)], [], { edgeLength: SCAN_EDGE }),
    markers: BODY.map((vertex) => [vertex, ...Object.values(SCANS).map(place(vertex))]),
  };
  const [SOUP, POINTS] = Object.keys(SCANS);
  return recipe(
    match,
    worn(1, 'pants', FEMALE, SOUP),
    worn(2, 'shirt', FEMALE, SOUP, OVER_BAND),
    worn(3, 'skirt', FEMALE, POINTS),
    worn(4, 'shirt', FEMALE, POINTS, OVER_BAND),
  );
}

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
      recipe(bodyMatch(), worn(1, 'skirt', FEMALE, HEAVY), worn(2, 'shirt', FEMALE, HEAVY, OVER_BAND)),
    ],
    ['dress-scans', 'One wardrobe, two scans', 'body-points', figure()],
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
