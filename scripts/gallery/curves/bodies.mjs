// Bodies: a skeleton of linked curves, posed joint by joint; a walk of poses one after the other.

import { bent, curve, curvesRecipe, plus, roundedAll, turnedFrom } from './chains.mjs';

const [X, Y, Z] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];
/**
 * Spine, left arm and left leg as their bones are; a line within the left side of the chest, so that the arm does not
 * take it along; where heel and toes of the left foot touch the ground.
 */
const JOINTS = {
  'body-female': {
    spine: [
      [0, 0.83, 0],
      [0, 0.94433, -0.0006],
      [0, 1.0331, 0.01137],
      [0, 1.18306, 0.0129],
      [0, 1.32318, -0.00144],
      [0, 1.42458, 0.03],
      [0, 1.53, 0.035],
    ],
    arm: [
      [0.15095, 1.24115, 0.02056],
      [0.22844, 1.15959, 0.02033],
      [0.30569, 1.07249, 0.0244],
      [0.3581, 1.01113, 0.08602],
      [0.41323, 0.9544, 0.1563],
    ],
    leg: [
      [0.09255, 0.8005, 0.01736],
      [0.108, 0.62, 0.044],
      [0.13119, 0.43902, 0.04742],
      [0.14524, 0.24996, 0.03773],
      [0.15991, 0.06718, 0.03025],
    ],
    chest: [
      [0.095, 1.2, 0.03],
      [0.095, 1.12, 0.05],
      [0.09, 1.03, 0.03],
    ],
    sole: [
      [0.16, 0, -0.01],
      [0.144, 0, 0.19],
    ],
  },
  'body-male': {
    spine: [
      [0, 1, -0.01],
      [0, 1.14773, -0.01595],
      [0, 1.21273, -0.02426],
      [0, 1.35583, -0.04714],
      [0, 1.56959, 0.01535],
      [0, 1.66909, 0.04],
      [0, 1.79, 0.0468],
    ],
    arm: [
      [0.19329, 1.46224, 0.02193],
      [0.2827, 1.3559, 0.0217],
      [0.36949, 1.26025, 0.02112],
      [0.44094, 1.19866, 0.12119],
      [0.50707, 1.12898, 0.21588],
    ],
    leg: [
      [0.1129, 0.97828, -0.00374],
      [0.13787, 0.738, 0.02595],
      [0.15676, 0.52377, 0.03163],
      [0.17784, 0.30794, 0.02575],
      [0.20209, 0.07541, 0.01732],
    ],
    chest: [
      [0.12, 1.42, 0],
      [0.12, 1.32, 0.02],
      [0.11, 1.22, 0],
    ],
    sole: [
      [0.2, 0, -0.03],
      [0.18, 0, 0.21],
    ],
  },
};
const LINKS = [
  { child: 'left arm', parent: 'spine', at: 0.56 },
  { child: 'right arm', parent: 'spine', at: 0.56 },
  { child: 'left chest', parent: 'spine', at: 0.45 },
  { child: 'right chest', parent: 'spine', at: 0.45 },
  { child: 'left leg', parent: 'spine', at: 0 },
  { child: 'right leg', parent: 'spine', at: 0 },
];

const mirrored = (points) => points.map(([x, y, z]) => [-x, y, z]);
const restOf = ({ spine, arm, chest, leg }) => ({
  spine,
  'left chest': chest,
  'right chest': mirrored(chest),
  'left arm': arm,
  'right arm': mirrored(arm),
  'left leg': leg,
  'right leg': mirrored(leg),
});

/** A limb turned at its first point and then at its middle; lists of axes and degrees. */
const limbTurned = (rest, { root = [], middle = [] }) => turnedFrom(turnedFrom(rest, 0, root), 2, middle);

/**
 * The body's curves in a pose, on its feet: as high as the lower one of them asks for.
 *
 * @param pose  of each limb its turns; of the spine `axis`, the degrees of `each` segment, and `twist`
 */
function postures(model, pose) {
  const joints = JOINTS[model];
  const rest = restOf(joints);
  const legs = [
    ['left leg', joints.sole],
    ['right leg', mirrored(joints.sole)],
  ].map(([id, sole]) => limbTurned([...rest[id], ...sole], pose[id] ?? {}).slice(-2));
  const lift = -Math.min(...legs.flat().map(([, y]) => y));
  const { axis = X, each = [], twist } = pose.spine ?? {};
  const spine = bent(rest.spine, axis, (k) => each[k] ?? 0).map((point) => plus(point, Y, lift));
  const limbs = Object.keys(rest).filter((id) => id in pose && id !== 'spine');
  return [
    { id: 'spine', posed: roundedAll(spine), ...(twist && { twist }) },
    ...limbs.map((id) => ({ id, posed: roundedAll(limbTurned(rest[id], pose[id])) })),
  ];
}

function bodyRecipe(model, pose, poses = []) {
  const posed = postures(model, pose);
  const curves = Object.entries(restOf(JOINTS[model])).map(([id, rest]) =>
    curve(id, rest, {
      ...posed.find((each) => each.id === id),
      ...(id === 'spine' && { anchor: 'start' }),
    }),
  );
  return curvesRecipe(model, curves, { links: LINKS, poses });
}

/** Both arms up, head back. */
export const cheering = () =>
  bodyRecipe('body-female', {
    spine: { each: [0, -3, -3, -4, -5, 0] },
    'left arm': { root: [[Z, 74]], middle: [[Z, 26]] },
    'right arm': { root: [[Z, -74]], middle: [[Z, -26]] },
  });

/** On one leg, leaning forward, the other leg and an arm stretched out behind and in front. */
export const balancing = () =>
  bodyRecipe('body-female', {
    spine: { each: [6, 7, 7, 4, -5, -12] },
    'left arm': {
      root: [
        [Z, 40],
        [X, -35],
      ],
      middle: [[X, 20]],
    },
    'right arm': { root: [[Z, -45]], middle: [[X, 25]] },
    'right leg': { root: [[X, 52]], middle: [[X, 12]] },
  });

/** 1 at `centre`, 0 from `width` away from it on; of a round of 1. */
function bump(phase, centre, width) {
  const away = Math.abs(((((phase - centre + 0.5) % 1) + 1) % 1) - 0.5);
  return away < width ? Math.cos((Math.PI * away) / (2 * width)) ** 2 : 0;
}

/** @param phase  of a leg, from 0 to 1: its heel comes down at 0 and leaves the ground a little after the half */
const legAt = (phase) => ({
  root: [[X, -24 * Math.cos(2 * Math.PI * phase) - 14 * bump(phase, 0.8, 0.25)]],
  middle: [[X, 5 + 10 * bump(phase, 0.15, 0.15) + 50 * bump(phase, 0.75, 0.22)]],
});
/** An arm goes with the leg of the other side. @param side  1: left, -1: right */
const armAt = (phase, side) => ({
  root: [
    [Z, -24 * side],
    [X, -20 * Math.cos(2 * Math.PI * phase)],
  ],
  middle: [[X, 6 - 10 * Math.cos(2 * Math.PI * phase)]],
});

/** As animators call them; eight are a round, and the last is the first again. */
const STAGES = ['contact', 'down', 'passing', 'up'];
const SECONDS = 1.12;

function walkAt(phase) {
  const twist = [0, 2, 4, 7, 7, 2, 0].map((degrees) => degrees * Math.cos(2 * Math.PI * phase));
  return {
    spine: { each: [0, 1, 1, 1, 0, -1], twist: twist.map((degrees) => Math.round(100 * degrees) / 100 + 0) },
    'left leg': legAt(phase),
    'right leg': legAt((phase + 0.5) % 1),
    'left arm': armAt((phase + 0.5) % 1, 1),
    'right arm': armAt(phase, -1),
  };
}

/** A step with each leg, to be played round and round. */
export function walking() {
  const poses = Array.from({ length: 9 }, (_, k) => ({
    name: `${k % 8 < 4 ? 'Left' : 'Right'} ${STAGES[k % 4]}${k === 8 ? ' again' : ''}`,
    time: Math.round((1000 * SECONDS * k) / 8) / 1000,
    curves: postures('body-male', walkAt((k % 8) / 8)),
  }));
  return bodyRecipe('body-male', walkAt(0), poses);
}
