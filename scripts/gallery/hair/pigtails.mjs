import { both } from './both.mjs';

/** Parted from brow to nape, a tail behind either ear. */
export const pigtails = {
  name: 'hair-pigtails',
  title: 'Two ponytails',
  head: 'head-elf',
  style(hand) {
    const [x, y, z] = hand.over([118, 2]);
    const s = hand.size;
    const tail = [
      [x, y, z],
      [x + 0.09 * s, y - 0.005 * s, z - 0.02 * s],
      [x + 0.16 * s, y - 0.04 * s, z - 0.03 * s],
      [x + 0.2 * s, y - 0.13 * s, z - 0.03 * s],
      [x + 0.21 * s, y - 0.28 * s, z - 0.02 * s],
      [x + 0.2 * s, y - 0.45 * s, z],
    ];
    const tied = { lift: 0.025 };
    return {
      partings: [hand.parting('0,52 0,82 180,60 180,20 180,-46')],
      streams: both([
        hand.stream(hand.skin('8,52 50,40 100,10', tied)),
        hand.stream(hand.skin('40,80 80,56 110,18', tied)),
        hand.stream(hand.skin('150,76 128,48 120,18', tied)),
        hand.stream(hand.skin('172,40 150,26 126,10', tied)),
        hand.stream(hand.skin('172,-10 150,-8 128,-2', tied)),
        hand.stream(hand.skin('172,-44 152,-28 128,-8', tied)),
        hand.stream(hand.skin('160,-56 146,-36 126,-10', tied)),
        hand.stream(hand.skin('146,-46 136,-28 124,-8', tied)),
        hand.stream(hand.skin('70,4 92,6 110,4', tied)),
      ]),
      ponytails: both([hand.ponytail(tail, [0.06, 0.07, 0.08, 0.075], 0.7)]),
      length: { max: 0.24 },
      volume: 0.005,
      detail: { clump: 0.5, curl: 0.1, frizz: 0.2 },
      material: { melanin: 0.2, redness: 0.1, colorVariation: 0.3 },
    };
  },
};
