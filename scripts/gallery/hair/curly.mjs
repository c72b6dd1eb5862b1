import { both } from './both.mjs';
import { along, towards } from './head-surface.mjs';

/** Short and full of curls, away from the head all round. */
export const curly = {
  name: 'hair-curly',
  title: 'Curls',
  head: 'head-male',
  style(hand) {
    const streams = [];
    for (const [elevation, azimuths] of [
      [84, [0]],
      [60, [0, 60, 120, 180]],
      [36, [30, 75, 120, 165]],
      [8, [80, 120, 160]],
      [-14, [130, 170]],
    ])
      for (const azimuth of azimuths) {
        const out = towards(azimuth, elevation);
        const root = hand.over([azimuth, elevation]);
        const line = [0, 0.06, 0.13, 0.2].map((d) => {
          const [px, py, pz] = along(root, out, d * hand.size);
          return [px, py - 0.9 * d * d * hand.size, pz];
        });
        streams.push(hand.stream(line));
      }
    return {
      streams: both(streams),
      length: { max: 0.085, variation: 0.3 },
      volume: 0.02,
      detail: { clump: 0.55, curl: 0.55, curlLength: 0.03, frizz: 0.5, flyaways: 0.04 },
      material: { melanin: 0.85, redness: 0.15 },
    };
  },
};
