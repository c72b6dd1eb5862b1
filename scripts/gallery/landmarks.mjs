// Places that have names in the data the gallery's people are made of: the same vertex on each of one kind. Chosen once.

/** Of heads: crown, nose, brow, chin, hairline, back of the head, nape, ears, eyes, mouth; then four places of the cut neck. */
export const HEAD = [
  677, 297, 237, 1079, 779, 1284, 652, 2937, 3229, 2499, 2484, 2100, 1333, 1627, 873, 858, 430, 882, 2515,
  893, 891,
];
export const NOSE_TIP = 297;

/** Of bodies: the same of the head, finger tips and toes, heels, knees, elbows, shoulders, hips, navel and crotch. */
export const BODY = [
  677, 297, 237, 4636, 779, 4841, 652, 10965, 11257, 7041, 7026, 6642, 8346, 11698, 7593, 12061, 7811, 12075,
  7977, 12035, 8195, 12215, 11370, 10197, 9023, 7224, 9900, 4890, 5184, 873, 858, 430, 2202, 5625, 1449, 5989,
  1667, 6003, 1833, 5963, 2051, 6143, 5297, 4103, 2879, 1069, 3794, 3619, 3874,
];

/** Of feet: toes and heel, then four places of the cut ankle. */
export const FOOT = [606, 944, 958, 918, 1098, 278, 14, 24, 12, 18];

/** A match of models of one kind. */
export const matchOf = (models, places, more = {}) => ({
  id: 'match 1',
  type: 'match',
  models,
  markers: places.map((vertex) => models.map(() => vertex)),
  ...more,
});

export const builtIn = (...models) => Object.fromEntries(models.map((model) => [model, { builtin: model }]));
