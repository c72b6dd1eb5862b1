import { both } from './both.mjs';

/** Parted in the middle, falling to the shoulders on either side. */
export const parted = {
  name: 'hair-parted',
  title: 'Middle parting',
  head: 'head-female',
  style(hand) {
    const fall = [
      [0.02, 0.14, -0.01],
      [0.01, 0.2, 0],
      [0, 0.25, 0.01],
      [0, 0.2, 0.01],
    ];
    return {
      partings: [hand.parting('0,52 0,80 180,70')],
      streams: both([
        hand.stream(hand.hang(hand.skin('8,54 40,42 72,14 82,-10', { lift: 0.05 }), fall)),
        hand.stream(hand.hang(hand.skin('35,80 75,52 92,18 97,-12', { lift: 0.06 }), fall)),
        hand.stream(hand.hang(hand.skin('140,80 115,46 118,10 120,-16', { lift: 0.06 }), fall)),
        hand.stream(hand.hang(hand.skin('172,66 152,36 146,4 146,-20', { lift: 0.05 }), fall)),
        hand.stream(hand.hang(hand.skin('176,30 172,0 170,-24', { lift: 0.04 }), fall)),
      ]),
      length: { max: 0.27, variation: 0.3 },
      detail: { clump: 0.4, curl: 0.06, frizz: 0.2 },
      material: { melanin: 0.3, redness: 0.15, colorVariation: 0.35 },
    };
  },
};
