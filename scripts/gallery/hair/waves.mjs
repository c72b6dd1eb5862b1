import { both } from './both.mjs';

/** Very long and loosely waved, away from the face. */
export const waves = {
  name: 'hair-waves',
  title: 'Long waves',
  head: 'head-elf',
  style(hand) {
    const fall = [
      [0.02, 0.16, -0.03],
      [0.02, 0.25, -0.01],
      [0.01, 0.3, 0],
      [0, 0.3, 0.01],
    ];
    return {
      partings: [hand.parting('0,54 0,84')],
      streams: both([
        hand.stream(hand.hang(hand.skin('8,58 50,56 92,30 112,0', { lift: 0.04 }), fall)),
        hand.stream(hand.hang(hand.skin('48,84 100,62 124,24 130,-8', { lift: 0.04 }), fall)),
        hand.stream(hand.hang(hand.skin('60,30 86,26 108,2 124,-20', { lift: 0.04 }), fall)),
        hand.stream(hand.hang(hand.skin('168,76 160,40 156,4 156,-18', { lift: 0.04 }), fall)),
        hand.stream(hand.hang(hand.skin('180,40 180,4 180,-22', { lift: 0.04 }), fall)),
      ]),
      length: { max: 0.36, variation: 0.3 },
      volume: 0.007,
      detail: { clump: 0.6, curl: 0.3, curlLength: 0.09, frizz: 0.2, flyaways: 0.01 },
      material: { melanin: 0.04, redness: 0, colorVariation: 0.15 },
    };
  },
};
