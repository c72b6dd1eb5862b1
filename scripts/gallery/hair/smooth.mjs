import { both } from './both.mjs';

/** Straight back from the brow, long behind. */
export const smooth = {
  name: 'hair-smooth',
  title: 'Swept back',
  head: 'head-female',
  style(hand) {
    const back = [
      [0.01, 0.2, -0.03],
      [0, 0.25, 0],
      [0, 0.25, 0.01],
    ];
    return {
      streams: both([
        hand.stream(hand.hang(hand.skin('0,50 0,89 180,50 180,5', { lift: 0.04 }), back)),
        hand.stream(hand.hang(hand.skin('25,46 60,75 160,40 165,0', { lift: 0.04 }), back)),
        hand.stream(hand.hang(hand.skin('52,34 90,48 140,20 150,-12', { lift: 0.04 }), back)),
        hand.stream(hand.hang(hand.skin('68,8 95,22 125,-2 138,-24', { lift: 0.04 }), back)),
        hand.stream(hand.hang(hand.skin('150,-14 152,-34', { lift: 0.03 }), back)),
      ]),
      length: { max: 0.25 },
      detail: { clump: 0.45, frizz: 0.15, flyaways: 0.01 },
      material: { melanin: 0.72, redness: 0.25 },
    };
  },
};
