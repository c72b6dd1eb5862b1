// Twelve handles on a face: two regions of the head stay, ten points of the face move.

import { pick, point, region } from './handles.mjs';
import { modelOf } from './models.mjs';

/** Where the points are on `head-female`; of those off the middle the left one of two. */
const PLACES = {
  'mouth corner': [0.0195, 0.102, 0.13],
  cheek: [0.036, 0.128, 0.118],
  'inner brow': [0.016, 0.184, 0.133],
  'outer brow': [0.041, 0.187, 0.118],
};
const MIDDLE = { 'Upper lip': [0, 0.108, 0.14], Chin: [0, 0.077, 0.131] };

/** How far each point goes; those on the right go as their mirror images do. */
export const SMILE = {
  'mouth corner': [0.008, 0.009, -0.005],
  cheek: [0.003, 0.006, 0.003],
  'inner brow': [0, 0.002, 0],
  'outer brow': [0.001, 0.006, 0],
  'Upper lip': [0, 0.0015, -0.002],
  Chin: [0, -0.002, -0.001],
};

export const SORROW = {
  'mouth corner': [-0.0005, -0.0085, -0.003],
  cheek: [-0.001, -0.003, 0],
  'inner brow': [-0.002, 0.007, 0.001],
  'outer brow': [0.001, -0.005, -0.001],
  'Upper lip': [0, 0.001, 0.001],
  Chin: [0, 0.003, 0.001],
};

/** @param moves  as `SMILE` has them */
export function faceHandles(moves) {
  const { points } = modelOf('head-female');
  const held = (name, inside) => region(name, pick(points, inside));
  return [
    held('Skull', (_x, y, z) => z < 0.045 || y > 0.225),
    held('Neck', (_x, y, z) => y < 0.045 && z > 0.06),
    ...Object.entries(PLACES).flatMap(([name, [x, y, z]]) => {
      const [bx, by, bz] = moves[name];
      return [
        point(`Left ${name}`, points, [x, y, z], [bx, by, bz]),
        point(`Right ${name}`, points, [-x, y, z], [-bx, by, bz]),
      ];
    }),
    ...Object.entries(MIDDLE).map(([name, place]) => point(name, points, place, moves[name])),
  ];
}
