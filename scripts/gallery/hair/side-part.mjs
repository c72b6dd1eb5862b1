/** Short at the sides, swept over from a parting at the side. */
export const sidePart = {
  name: 'hair-side-part',
  title: 'Side parting',
  head: 'head-male',
  style(hand) {
    const over = { lift: 0.05 };
    return {
      partings: [hand.parting('32,50 48,66 100,74', [12, 0])],
      streams: [
        hand.stream(hand.skin('28,54 -12,60 -46,46 -66,30', over)),
        hand.stream(hand.skin('60,78 -60,76 -84,44 -92,22', over)),
        hand.stream(hand.skin('120,80 -140,74 -118,40 -116,12', over)),
        hand.stream(hand.skin('44,48 66,28 84,8')),
        hand.stream(hand.skin('80,62 96,34 108,6')),
        hand.stream(hand.skin('140,66 146,30 148,-8')),
        hand.stream(hand.skin('-160,60 -165,20 -166,-16')),
        hand.stream(hand.skin('-72,16 -98,4 -122,-12')),
      ],
      length: { max: 0.09, variation: 0.15 },
      volume: 0.012,
      detail: { clump: 0.5, frizz: 0.15, flyaways: 0.01 },
      material: { melanin: 0.62, redness: 0.3 },
    };
  },
};
