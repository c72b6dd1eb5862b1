// The gallery's models bent by curves: control points stand where a stroke along the limb would have put them.

const rounded = (n) => Math.round(n * 1e5) / 1e5 + 0;
const roundedAll = (points) => points.map((point) => point.map(rounded));
const radians = (degrees) => (degrees * Math.PI) / 180;

/** A place of a polyline, by the share of its length. */
function placeOn(points, share) {
  const lengths = points.slice(1).map((p, k) => Math.hypot(...p.map((x, c) => x - points[k][c])));
  let left = share * lengths.reduce((a, b) => a + b);
  for (const [k, length] of lengths.entries()) {
    if (left <= length || k === lengths.length - 1) {
      const t = left / length;
      return points[k].map((x, c) => x + t * (points[k + 1][c] - x));
    }
    left -= length;
  }
}

const evenly = (points, count) => Array.from({ length: count }, (_, k) => placeOn(points, k / (count - 1)));

/** A vector turned about a unit axis (Rodrigues). */
function turnedAbout(axis, degrees, v) {
  const [c, s] = [Math.cos(radians(degrees)), Math.sin(radians(degrees))];
  const along = (1 - c) * axis.reduce((sum, a, k) => sum + a * v[k], 0);
  const [x, y, z] = axis;
  const across = [y * v[2] - z * v[1], z * v[0] - x * v[2], x * v[1] - y * v[0]];
  return v.map((value, k) => c * value + s * across[k] + along * axis[k]);
}

/** A chain whose segments are turned about an axis, each by `degrees(k)` more than the one before it. */
function bent(points, axis, degrees) {
  const length = Math.hypot(...axis);
  const unit = axis.map((a) => a / length);
  const out = [points[0]];
  let sum = 0;
  for (let k = 1; k < points.length; k++) {
    sum += degrees(k - 1);
    const segment = turnedAbout(
      unit,
      sum,
      points[k].map((x, c) => x - points[k - 1][c]),
    );
    out.push(out[k - 1].map((x, c) => x + segment[c]));
  }
  return out;
}

/** @param posture  `posed`, `twist`, `scale`, `rigid` …; points are rounded here */
function curve(id, rest, { posed, ...posture } = {}, kind = 'skeleton') {
  return { id, kind, rest: roundedAll(rest), ...(posed && { posed: roundedAll(posed) }), ...posture };
}

const recipe = (model, curves, { links = [], poses = [] } = {}) => ({
  lissom: 1,
  models: { [model]: { builtin: model } },
  steps: [{ id: 'curves 1', type: 'curves', model, curves, links, options: {}, poses }],
  outputs: [],
});

/** Each arm from its shoulder to its tip, rolled up by 250 degrees. */
function octopus() {
  const arms = [
    [
      0.25869, 0.38, 0.10715, 0.52381, 0.16, 0.16769, 0.87692, 0.1, 0.20251, 1.20736, 0.2, 0.17518, 1.44728,
      0.36, 0.08871,
    ],
    [
      0.10715, 0.38, 0.25869, 0.23692, 0.16, 0.49636, 0.42988, 0.1, 0.7907, 0.63832, 0.2, 1.03969, 0.82262,
      0.36, 1.19407,
    ],
    [
      -0.10715, 0.38, 0.25869, -0.24069, 0.16, 0.49454, -0.44188, 0.1, 0.78406, -0.6619, 0.2, 1.02483,
      -0.85861, 0.36, 1.16846,
    ],
    [
      -0.25869, 0.38, 0.10715, -0.51152, 0.16, 0.2021, -0.84236, 0.1, 0.31691, -1.14877, 0.2, 0.41076,
      -1.37318, 0.36, 0.4657,
    ],
  ].map((flat) => [0, 3, 6, 9, 12].map((at) => flat.slice(at, at + 3)));
  const curves = arms.slice(0, 4).map((joints, at) => {
    const rest = evenly(joints, 9);
    const [ex, , ez] = joints[4];
    // About the horizontal axis across the arm: up and inwards.
    const posed = bent(rest, [ez, 0, -ex], (k) => (k < 3 ? 0 : -250 / 5));
    return curve(`arm ${at + 1}`, rest, { posed, anchor: 'start' });
  });
  return recipe('octopus', curves);
}

/** Two arms that go their own ways, and a trunk that leans. */
function cactus() {
  const left = evenly(
    [
      [0.3, 0.82, 0.01],
      [0.55, 0.85, 0.02],
      [0.66, 1.05, 0.02],
      [0.66, 1.6, 0.02],
    ],
    8,
  );
  const right = evenly(
    [
      [-0.27, 1.13, -0.02],
      [-0.45, 1.15, -0.04],
      [-0.56, 1.32, -0.04],
      [-0.56, 1.75, -0.04],
    ],
    8,
  );
  const trunk = evenly(
    [
      [0, 0.05, 0],
      [0, 0.9, 0],
      [0.02, 2.0, 0],
    ],
    6,
  );
  return recipe(
    'cactus',
    [
      curve('trunk', trunk, { posed: bent(trunk, [0, 0, 1], () => -5), anchor: 'start' }),
      curve('left arm', left, { posed: bent(left, [0, 0, 1], (k) => [0, 0, 0, -8, -16, -20, -20][k]) }),
      curve('right arm', right, { posed: bent(right, [1, 0, 0.6], (k) => [0, 0, 0, 8, 14, 18, 18][k]) }),
    ],
    {
      links: [
        { child: 'left arm', parent: 'trunk', at: 0.41 },
        { child: 'right arm', parent: 'trunk', at: 0.56 },
      ],
    },
  );
}

/** Legs of straight bones, two of them lifted. */
function horse() {
  const fore = (side) => [
    [side, 1.05, 0.6],
    [side, 0.598, 0.63],
    [side, 0.1725, 0.61],
    [side, 0.05, 0.66],
  ];
  const hind = (side) => [
    [side, 1.0, -0.59],
    [side, 0.598, -0.55],
    [side, 0.345, -0.7],
    [side, 0.05, -0.63],
  ];
  const rigid = [0, 1];
  const limb = (id, rest, degrees) =>
    curve(id, rest, {
      ...(degrees && { posed: bent(rest, [1, 0, 0], (k) => degrees[k]) }),
      rigid,
      anchor: 'start',
    });
  return recipe('horse', [
    limb('left fore leg', fore(0.15), [-50, 85, 20]),
    limb('right fore leg', fore(-0.15), [0, 0, 0]),
    limb('left hind leg', hind(0.15), [0, 0, 0]),
    limb('right hind leg', hind(-0.15), [-22, 30, -5]),
  ]);
}

/** A bar that is bent and twisted at once. */
function bar(ys) {
  const [low, high] = [Math.min(...ys), Math.max(...ys)];
  const rest = evenly(
    [
      [0, low, 0],
      [0, high, 0],
    ],
    7,
  );
  const twist = rest.map((_, k) => 30 * k);
  return recipe('bar', [
    curve('axis', rest, { posed: bent(rest, [0, 0, 1], (k) => (k === 0 ? 0 : -22)), twist, anchor: 'start' }),
  ]);
}

const SPINE = [
  [0, 0.83, 0],
  [0, 0.94433, -0.0006],
  [0, 1.0331, 0.01137],
  [0, 1.18306, 0.0129],
  [0, 1.32318, -0.00144],
  [0, 1.42458, 0.03],
  [0, 1.53, 0.035],
];
const ARM = [
  [0.15095, 1.24115, 0.02056],
  [0.22844, 1.15959, 0.02033],
  [0.30569, 1.07249, 0.0244],
  [0.3581, 1.01113, 0.08602],
  [0.41323, 0.9544, 0.1563],
];
const LEG = [
  [0.09255, 0.8005, 0.01736],
  [0.108, 0.62, 0.044],
  [0.13119, 0.43902, 0.04742],
  [0.14524, 0.24996, 0.03773],
  [0.15991, 0.06718, 0.03025],
];
const mirrored = (points) => points.map(([x, y, z]) => [-x, y, z]);

/** The skeleton of a body; each limb is turned at its first point, and at its middle. */
function body(pose) {
  const limb = (rest, { axis = [1, 0, 0], root = 0, middle = 0, hinge = axis }) => {
    const upper = bent(rest, axis, (k) => (k === 0 ? root : 0));
    if (middle === 0) return upper;
    const bend = bent(upper.slice(2), hinge, (k) => (k === 0 ? middle : 0));
    return [...upper.slice(0, 2), ...bend];
  };
  const rests = {
    spine: SPINE,
    'left arm': ARM,
    'right arm': mirrored(ARM),
    'left leg': LEG,
    'right leg': mirrored(LEG),
  };
  const postures = Object.entries(pose).map(([id, how]) => ({
    id,
    posed: roundedAll(id === 'spine' ? bent(SPINE, how.axis, () => how.each) : limb(rests[id], how)),
  }));
  return { rests, postures };
}

const LINKS = [
  { child: 'left arm', parent: 'spine', at: 0.64 },
  { child: 'right arm', parent: 'spine', at: 0.64 },
  { child: 'left leg', parent: 'spine', at: 0 },
  { child: 'right leg', parent: 'spine', at: 0 },
];

function bodyRecipe(model, pose, poses = []) {
  const { rests, postures } = body(pose);
  const curves = Object.entries(rests).map(([id, rest]) =>
    curve(id, rest, {
      ...postures.find((posture) => posture.id === id),
      ...(id === 'spine' && { anchor: 'start' }),
    }),
  );
  return recipe(model, curves, { links: LINKS, poses });
}

const CHEERING = {
  'left arm': { axis: [0, 0, 1], root: 95, middle: 15 },
  'right arm': { axis: [0, 0, 1], root: -95, middle: -15 },
  spine: { axis: [1, 0, 0], each: -2 },
};

/** A stride with the left leg in front, or in the middle of one. @param swing  1 to -1 */
const stride = (swing, lifted) => ({
  'left leg': { root: -26 * swing, middle: lifted === 'left' ? 45 : swing < 0 ? 12 : 4 },
  'right leg': { root: 26 * swing, middle: lifted === 'right' ? 45 : swing > 0 ? 12 : 4 },
  'left arm': { root: 24 * swing, middle: -18 },
  'right arm': { root: -24 * swing, middle: -18 },
});
const WALK = [stride(1), stride(0, 'right'), stride(-1), stride(0, 'left'), stride(1)];

const walking = () =>
  bodyRecipe(
    'body-male',
    WALK[0],
    WALK.map((pose, k) => ({ name: `step ${k + 1}`, time: 0.3 * k, curves: body(pose).postures })),
  );

/** A half turned band, pulled out on one side. */
function moebius() {
  const around = Array.from({ length: 9 }, (_, k) => {
    const angle = radians(-100 + 25 * k);
    return [Math.cos(angle), 0, Math.sin(angle)];
  });
  const posed = around.map(([x, , z], k) => {
    const lift = Math.sin((Math.PI * k) / 8) ** 2;
    return [x * (1 + 0.35 * lift), 0.75 * lift, z];
  });
  return recipe('moebius', [curve('band', around, { posed, anchor: 'start' }, 'surface')]);
}

/** Three leaves of a book, two of them turned. */
function sheets() {
  const leaf = (degrees) =>
    Array.from({ length: 6 }, (_, k) => {
      const out = 0.12 + 0.17 * k;
      return [out * Math.cos(radians(degrees)), 0, out * Math.sin(radians(degrees))];
    });
  const [a, b] = [leaf(0), leaf(120)];
  return recipe('sheets', [
    curve(
      'first leaf',
      a,
      { posed: bent(a, [0, 1, 0], (k) => (k === 0 ? 0 : 24)), anchor: 'start' },
      'surface',
    ),
    curve(
      'second leaf',
      b,
      { posed: bent(b, [0, 1, 0], (k) => (k === 0 ? 0 : -16)), anchor: 'start' },
      'surface',
    ),
  ]);
}

/** @param barPoints  of the bar; its axis is found from them */
export function curveExamples(barPoints) {
  return [
    ['curves-octopus', 'Octopus, arms rolled up', 'octopus', octopus()],
    ['curves-cactus', 'Cactus, waving', 'cactus', cactus()],
    ['curves-horse', 'Horse, pawing', 'horse', horse()],
    ['curves-body-cheering', 'Body, arms up', 'body-female', bodyRecipe('body-female', CHEERING)],
    ['curves-body-walking', 'Body, walking', 'body-male', walking()],
    ['curves-bar', 'Bar, bent and twisted', 'bar', bar(barPoints.map(([, y]) => y))],
    ['curves-moebius', 'M\u00f6bius strip, pulled', 'moebius', moebius()],
    ['curves-sheets', 'Three sheets at one edge', 'sheets', sheets()],
  ];
}
