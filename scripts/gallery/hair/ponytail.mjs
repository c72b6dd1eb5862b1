import { both } from './both.mjs';

/** Drawn back into one tail, high behind. */
export const ponytail = {
  name: 'hair-ponytail',
  title: 'Ponytail',
  head: 'head-female',
  style(hand) {
    const knot = hand.over([180, 34]);
    const [, y, z] = knot;
    const s = hand.size;
    const tail = [
      [0, y, z],
      [0, y + 0.03 * s, z - 0.1 * s],
      [0, y + 0.02 * s, z - 0.18 * s],
      [0, y - 0.06 * s, z - 0.26 * s],
      [0, y - 0.2 * s, z - 0.3 * s],
      [0, y - 0.4 * s, z - 0.3 * s],
      [0, y - 0.6 * s, z - 0.28 * s],
    ];
    const tied = { lift: 0.025 };
    return {
      streams: both([
        hand.stream(hand.skin('0,50 0,88 180,48', tied)),
        hand.stream(hand.skin('30,46 70,66 172,44', tied)),
        hand.stream(hand.skin('58,28 95,44 165,36', tied)),
        hand.stream(hand.skin('72,4 105,18 160,28', tied)),
        hand.stream(hand.skin('125,-16 140,4 168,24', tied)),
        hand.stream(hand.skin('180,-46 180,-10 180,22', tied)),
        hand.stream(hand.skin('152,-44 160,-12 170,20', tied)),
        hand.stream(hand.skin('128,-36 146,-8 166,20', tied)),
      ]),
      ponytails: [hand.ponytail(tail, [0.075, 0.085, 0.095, 0.1], 0.7)],
      length: { max: 0.32 },
      volume: 0.005,
      detail: { clump: 0.5, curl: 0.05, frizz: 0.15 },
      material: { melanin: 0.42, redness: 0.8, colorVariation: 0.25 },
    };
  },
};
