import { both } from './both.mjs';

/** Chin long, parted at the side, turned in at the ends. */
export const bob = {
  name: 'hair-bob',
  title: 'Bob',
  head: 'head-female',
  style(hand) {
    const beside = [
      [0.012, 0.1, -0.004],
      [0, 0.08, -0.004],
      [-0.015, 0.05, -0.004],
      [-0.035, 0.03, -0.004],
    ];
    const behind = [
      [0.004, 0.1, -0.012],
      [0, 0.08, 0],
      [0, 0.05, 0.008],
      [0, 0.03, 0.012],
    ];
    const full = { lift: 0.07 };
    return {
      partings: [hand.parting('24,50 34,72 90,82')],
      streams: [
        hand.stream(hand.hang(hand.skin('30,52 52,40 70,12 80,-14', full), beside)),
        hand.stream(hand.hang(hand.skin('18,54 -30,54 -64,24 -80,-14', full), beside)),
        hand.stream(hand.hang(hand.skin('50,76 84,48 96,4', full), beside)),
        hand.stream(hand.hang(hand.skin('20,76 -70,66 -92,34 -97,2', full), beside)),
        ...both([
          hand.stream(hand.hang(hand.skin('125,78 126,36 126,0', full), beside)),
          hand.stream(hand.hang(hand.skin('158,76 157,36 156,0', full), behind)),
          hand.stream(hand.hang(hand.skin('180,76 180,36 180,0', full), behind)),
        ]),
      ],
      length: { max: 0.25, variation: 0.05, map: hand.cutAt(0.07, 0.25) },
      volume: 0.012,
      detail: { clump: 0.35, frizz: 0.1, flyaways: 0.01 },
      material: { melanin: 0.92, redness: 0.1, colorVariation: 0.15 },
    };
  },
};
