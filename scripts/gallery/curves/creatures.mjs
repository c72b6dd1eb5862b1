// Limbs of the gallery's creatures, bent by curves inside them.

import { bent, curve, curvesRecipe, evenly, jointed, radians } from './chains.mjs';

/** Joints of the octopus's arms as seen from above; how high they are is the same for all. */
const ARMS = [
  [0.25869, 0.10715, 0.52381, 0.16769, 0.87692, 0.20251, 1.20736, 0.17518, 1.44728, 0.08871],
  [0.10715, 0.25869, 0.23692, 0.49636, 0.42988, 0.7907, 0.63832, 1.03969, 0.82262, 1.19407],
  [-0.10715, 0.25869, -0.24069, 0.49454, -0.44188, 0.78406, -0.6619, 1.02483, -0.85861, 1.16846],
  [-0.25869, 0.10715, -0.51152, 0.2021, -0.84236, 0.31691, -1.14877, 0.41076, -1.37318, 0.4657],
  [-0.25869, -0.10715, -0.52353, -0.16858, -0.87623, -0.20549, -1.20645, -0.18132, -1.44665, -0.09853],
  [-0.10715, -0.25869, -0.21725, -0.50527, -0.36653, -0.82198, -0.51171, -1.1075, -0.62573, -1.30804],
  [0.10715, -0.25869, 0.20835, -0.50901, 0.33744, -0.83435, 0.45267, -1.13291, 0.53236, -1.34874],
  [0.25869, -0.10715, 0.49265, -0.24454, 0.77707, -0.45405, 1.00907, -0.68569, 1.14111, -0.89463],
];
const HEIGHTS = [0.38, 0.16, 0.1, 0.2, 0.36];
/** How the arms are rolled up, more and more towards their tips. */
const ROLL = [0, 0, 0, 10, 22, 30, 34, 34, 30, 24];

/** All arms rolled up and inwards. */
export function octopus() {
  const curves = ARMS.map((flat, at) => {
    const joints = HEIGHTS.map((y, k) => [flat[2 * k], y, flat[2 * k + 1]]);
    const rest = evenly(joints, ROLL.length + 1);
    const [x, , z] = joints.at(-1);
    // Across the arm, and a little upwards, so that the tip passes beside what it is rolled up on.
    const axis = [-z, 0.25 * Math.hypot(x, z), x];
    return curve(`arm ${at + 1}`, rest, { posed: bent(rest, axis, (k) => ROLL[k]), anchor: 'start' });
  });
  return curvesRecipe('octopus', curves);
}

/** The middle of an arm of the cactus, from the trunk out, through its turn, and up. */
function armOfCactus(side, { low, out, turn, high }) {
  const corner = Array.from({ length: 9 }, (_, k) => {
    const angle = radians(-90 + (90 * k) / 8);
    return [side * (out - turn + turn * Math.cos(angle)), low + turn + turn * Math.sin(angle), 0];
  });
  return evenly([[0.26 * side, low, 0], ...corner, [side * out, high, 0]], 10);
}

/** Two arms that go their own ways, and a trunk that leans. */
export function cactus() {
  const trunk = evenly(
    [
      [0, 0.05, 0],
      [0, 2, 0],
    ],
    6,
  );
  const left = armOfCactus(1, { low: 0.8, out: 0.7, turn: 0.28, high: 1.56 });
  const right = armOfCactus(-1, { low: 1.08, out: 0.6, turn: 0.25, high: 1.7 });
  const waves = [0, 0, -8, -14, -14, -4, 14, 22, 14];
  const beckons = [0, 0, 0, 4, 10, 16, 22, 22, 12];
  return curvesRecipe(
    'cactus',
    [
      curve('trunk', trunk, { posed: bent(trunk, [0, 0, 1], (k) => (k < 1 ? 0 : -5)), anchor: 'start' }),
      curve('left arm', left, { posed: bent(left, [0, 0, 1], (k) => waves[k]) }),
      curve('right arm', right, { posed: bent(right, [1, 0, 0.4], (k) => beckons[k]) }),
    ],
    {
      links: [
        { child: 'left arm', parent: 'trunk', at: 0.385 },
        { child: 'right arm', parent: 'trunk', at: 0.528 },
      ],
    },
  );
}

/** Legs of straight bones, two of them lifted. */
export function horse() {
  const fore = (side) => [
    [side, 0.98, 0.605],
    [side, 0.598, 0.63],
    [side, 0.1725, 0.61],
    [side, 0.05, 0.65],
  ];
  const hind = (side) => [
    [side, 0.95, -0.585],
    [side, 0.598, -0.55],
    [side, 0.345, -0.7],
    [side, 0.05, -0.63],
  ];
  const leg = (id, joints, reach, degrees) => {
    const { rest, rigid, pose } = jointed(joints, reach);
    return curve(id, rest, { ...(degrees && { posed: pose([1, 0, 0], degrees) }), rigid, anchor: 'start' });
  };
  const [foreReach, hindReach] = [
    [0.2, 0.1, 0.045],
    [0.18, 0.1, 0.08],
  ];
  return curvesRecipe('horse', [
    leg('left fore leg', fore(0.15), foreReach, [-44, 84, 22]),
    leg('right fore leg', fore(-0.15), foreReach),
    leg('left hind leg', hind(0.15), hindReach),
    leg('right hind leg', hind(-0.15), hindReach, [-20, 34, -20]),
  ]);
}
