// The gallery's poses: one model is posed, another gets the pose. Parts that match are picked by geometry, as balls about
// the same joints of both. Written by scripts/gallery.mjs.

import { faceHandles, SMILE } from './face.mjs';
import { after, deformStep, identity, pick, region, turn } from './handles.mjs';
import { modelOf } from './models.mjs';

/** Of each ball `[x, y, z, radius]` the vertices within it that are nearer to no other one, in shares of the radii. */
function balls(model, list) {
  const share = ([cx, cy, cz, r], x, y, z) => Math.hypot(x - cx, y - cy, z - cz) / r;
  const { points } = modelOf(model);
  return list.map((ball, i) =>
    pick(points, (...p) => {
      const own = share(ball, ...p);
      return own < 1 && list.every((other, k) => k === i || share(other, ...p) > own);
    }),
  );
}

const mirrored = ([x, y, z, r]) => [-x, y, z, r];

/** Joints of the four-legged models: places and radii. */
const JOINTS = {
  horse: {
    chest: [0, 1.33, 0.45, 0.32],
    hip: [0, 1.33, -0.63, 0.3],
    head: [0, 2.03, 1.25, 0.26],
    tail: [0, 0.66, -1.14, 0.17],
    knee: [0.15, 0.6, 0.63, 0.11],
    hoof: [0.15, 0.05, 0.68, 0.16],
    hock: [0.15, 0.36, -0.69, 0.1],
    hind: [0.15, 0.05, -0.59, 0.16],
  },
  cow: {
    chest: [0, 1.07, 0.5, 0.4],
    hip: [0, 1.07, -0.7, 0.38],
    head: [0, 1.22, 1.17, 0.3],
    tail: [0, 0.36, -1.22, 0.17],
    knee: [0.195, 0.46, 0.69, 0.11],
    hoof: [0.195, 0.05, 0.75, 0.17],
    hock: [0.195, 0.27, -0.75, 0.1],
    hind: [0.195, 0.05, -0.65, 0.17],
  },
  dog: {
    chest: [0, 0.96, 0.4, 0.25],
    hip: [0, 0.96, -0.56, 0.23],
    head: [0, 1.3, 0.98, 0.24],
    tail: [0, 0.55, -0.94, 0.14],
    knee: [0.117, 0.42, 0.568, 0.09],
    hoof: [0.117, 0.05, 0.63, 0.14],
    hock: [0.117, 0.25, -0.628, 0.08],
    hind: [0.117, 0.05, -0.525, 0.14],
  },
};

/** Names of the handles, and what each holds. */
const PARTS = [
  ['Chest', ({ chest }) => chest],
  ['Hip', ({ hip }) => hip],
  ['Head', ({ head }) => head],
  ['Tail', ({ tail }) => tail],
  ['Left knee', ({ knee }) => knee],
  ['Right knee', ({ knee }) => mirrored(knee)],
  ['Left front hoof', ({ hoof }) => hoof],
  ['Right front hoof', ({ hoof }) => mirrored(hoof)],
  ['Left hind hoof', ({ hind }) => hind],
  ['Right hind hoof', ({ hind }) => mirrored(hind)],
];

const counterparts = (model) =>
  balls(
    model,
    PARTS.map(([, of]) => of(JOINTS[model])),
  );

const X = [1, 0, 0];

/** A horse that rears: turned up about its hips, its forelegs bent, its head drawn in. */
function rearing() {
  const body = turn(X, -38, [0, 1.05, -0.62]);
  const neck = after(body, turn(X, 12, [0, 1.35, 0.62]));
  const head = after(neck, turn(X, 24, [0, 2.05, 1.05]));
  const leg = (lift, bend) => {
    const knee = after(body, turn(X, -lift, [0, 1.09, 0.6]));
    return [knee, after(knee, turn(X, bend, [0, 0.6, 0.63]))];
  };
  const [left, right] = [leg(62, 85), leg(38, 95)];
  const tail = turn(X, 32, [0, 1.31, -0.86], [0, 0, -0.1]);
  const maps = {
    Chest: body,
    Hip: turn(X, -19, [0, 1.05, -0.62]),
    Head: head,
    Tail: tail,
    'Left knee': left[0],
    'Right knee': right[0],
    'Left front hoof': left[1],
    'Right front hoof': right[1],
  };
  const sets = counterparts('horse');
  return deformStep(
    'rearing',
    'horse',
    'all',
    PARTS.map(([name], i) => region(name, sets[i], maps[name] ?? identity)),
  );
}

/** Ends of the arms, and where they bend, in the order of both models. */
const ARMS = {
  octopus: [
    [1.207, 0.175],
    [0.638, 1.04],
    [-0.662, 1.025],
    [-1.149, 0.411],
    [-1.206, -0.181],
    [-0.512, -1.108],
    [0.453, -1.133],
    [1.009, -0.686],
  ],
  squid: [
    [1.527, 0.262],
    [0.593, 1.431],
    [-0.679, 1.392],
    [-1.209, 0.969],
    [-1.524, -0.28],
    [-0.21, -1.535],
    [0.208, -1.535],
    [1.265, -0.894],
  ],
};
const HEADS = { octopus: [0, 0.86, -0.06, 0.36], squid: [0, 0.86, -0.08, 0.32] };

const armed = (model) =>
  balls(model, [HEADS[model], ...ARMS[model].map(([x, z]) => [1.1 * x, 0.26, 1.1 * z, 0.3])]);

/** An octopus that lifts the ends of its arms, one more than the next, its head a little to the side. */
function dancing() {
  const sets = armed('octopus');
  const arms = ARMS.octopus.map(([x, z], i) => {
    const length = Math.hypot(x, z);
    const [ux, uz] = [x / length, z / length];
    // About the horizontal axis across the arm: up and inwards; then around the middle.
    const lift = turn([uz, 0, -ux], i % 2 ? -35 : -100, [0.62 * ux, 0.14, 0.62 * uz]);
    const map = after(turn([0, 1, 0], i % 2 ? 14 : 0, [0, 0, 0]), lift);
    return region(`Arm ${i + 1}`, sets[i + 1], map);
  });
  const head = region('Head', sets[0], turn([0.3, 0, 1], 14, [0, 0.5, 0]));
  return deformStep('dancing', 'octopus', 'all', [head, ...arms]);
}

const smiling = () => deformStep('smiling', 'head-female', 'all', faceHandles(SMILE));

/** The heads are of one make: what is a place on one of them is the same vertex on the others. */
const faced = () => smiling().handles.map(({ vertices }) => vertices);

/** @param parts  a model's counterparts of the pose's handles */
const recipe = (pose, parts, ...targets) => ({
  lissom: 1,
  models: Object.fromEntries([pose.model, ...targets].map((model) => [model, { builtin: model }])),
  steps: [
    pose,
    ...targets.map((model) => ({
      id: `${model} ${pose.id}`,
      type: 'transfer',
      model,
      like: pose.id,
      handles: parts(model),
      strength: 1,
      keepStretch: false,
    })),
  ],
  outputs: [],
});

/** @returns name, title, model and recipe of each example */
export function transferExamples() {
  return [
    ['transfer-cow-rearing', 'Cow, rearing like a horse', 'cow', recipe(rearing(), counterparts, 'cow')],
    ['transfer-dog-rearing', 'Dog, rearing like a horse', 'dog', recipe(rearing(), counterparts, 'dog')],
    ['transfer-squid-dancing', 'Squid, dancing like an octopus', 'squid', recipe(dancing(), armed, 'squid')],
    ['transfer-elf-smiling', 'Elf, smiling', 'head-elf', recipe(smiling(), faced, 'head-elf')],
  ];
}
