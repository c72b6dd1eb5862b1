// The gallery's hairstyles: strokes placed on the heads by geometry, as a hand would draw them. Written by
// scripts/gallery.mjs. Directions are degrees from the middle of the scalp: azimuth from the face round by the
// left ear (+x), elevation upwards.

import { along, HeadSurface, slerp, towards, unit } from './lib/head-surface.mjs';

const PLACES = 3;
const round = (point) => point.map((x) => Math.round(x * 10 ** PLACES) / 10 ** PLACES + 0);

/** One head with the moves of a hand on it. Lengths are parts of the head's height. */
class Hand {
  constructor(file) {
    this.head = new HeadSurface(file);
    this.size = this.head.height;
  }

  /** A point over the skin. */
  over([azimuth, elevation], lift = 0) {
    return this.overDirection(towards(azimuth, elevation), lift);
  }

  overDirection(direction, lift = 0) {
    const { point } = this.head.at(direction);
    return along(point, unit(direction), lift * this.size);
  }

  /** Over the skin from stop to stop by the shortest ways, `lift` growing from nothing. */
  skin(stops, { lift = 0.02, steps = 5 } = {}) {
    const directions = stops.map(([azimuth, elevation]) => towards(azimuth, elevation));
    const out = [];
    const spans = directions.length - 1;
    for (let i = 0; i < spans; i++)
      for (let k = i === 0 ? 0 : 1; k <= steps; k++) {
        const t = (i + k / steps) / spans;
        out.push(
          this.overDirection(slerp(directions[i], directions[i + 1], k / steps), lift * Math.min(1, 3 * t)),
        );
      }
    return out;
  }

  /** On from the last point in steps: each `[out, down, forward]` in parts of the head's height. */
  hang(line, steps) {
    const side = Math.abs(line.at(-1)[0]) < 1e-3 ? 0 : Math.sign(line.at(-1)[0]);
    const out = [...line];
    for (const [aside, down, forward] of steps) {
      const [x, y, z] = out.at(-1);
      out.push([x + side * aside * this.size, y - down * this.size, z + forward * this.size]);
    }
    return out;
  }

  stream(line, fade = false) {
    const points = line.map(round);
    return fade ? { points, fade } : { points };
  }

  /**
   * How much shorter hair is cut that grows lower, so that it all ends at one level.
   *
   * @param max  of the hair that is not shortened
   */
  cutAt(level, max) {
    const parts = [0.12, 0.3, 0.48, 0.66, 0.84].map((factor) => ({ factor, chosen: [] }));
    for (const v of this.head.scalp) {
      const fall = (1.15 * (this.head.points[v][1] - level)) / max;
      const part = parts.findLast(({ factor }) => factor <= Math.max(fall, 0.12));
      if (fall < 1) part.chosen.push(v);
    }
    return parts
      .filter(({ chosen }) => chosen.length > 0)
      .map(({ factor, chosen }) => ({ vertices: setOf(chosen), factor }));
  }

  parting(stops, tilt) {
    const points = this.skin(stops, { lift: 0, steps: 4 }).map(round);
    return tilt ? { points, tilt } : { points };
  }

  /** A ring about `centre` across `axis`. */
  ring(centre, axis, radius) {
    const w = unit(axis);
    const u = unit(Math.abs(w[1]) < 0.9 ? [w[2], 0, -w[0]] : [1, 0, 0]);
    const v = [w[1] * u[2] - w[2] * u[1], w[2] * u[0] - w[0] * u[2], w[0] * u[1] - w[1] * u[0]];
    return Array.from({ length: 8 }, (_, i) => {
      const angle = (2 * Math.PI * i) / 8;
      const across = u.map((x, k) => Math.cos(angle) * x + Math.sin(angle) * v[k]);
      return along(centre, across, radius * this.size);
    });
  }

  /** A tail along `spine`, tied at its second point, with its outline on either side: radii along the spine. */
  ponytail(spine, radii, tightness) {
    const axis = spine.map((_, i) => {
      const [a, b] = [spine[Math.max(0, i - 1)], spine[Math.min(i + 1, spine.length - 1)]];
      return unit(b.map((x, k) => x - a[k]));
    });
    const across = axis.map(([x, y, z]) => (Math.abs(x) > 0.9 ? unit([0, z, -y]) : unit([z, 0, -x])));
    const outline = (side) =>
      radii.map((radius, i) => round(along(spine[i + 1], across[i + 1], side * radius * this.size)));
    return {
      spine: spine.map(round),
      section: this.ring(spine[1], axis[1], radii[0]).map(round),
      profiles: [outline(1), outline(-1)],
      ...(tightness !== undefined && { tightness }),
    };
  }
}

/** Vertices in the recipe's shortest form. */
function setOf(chosen) {
  const ranges = [];
  for (const v of chosen) {
    if (ranges.at(-1)?.[1] === v - 1) ranges.at(-1)[1] = v;
    else ranges.push([v, v]);
  }
  return ranges.length * 2 < chosen.length ? { ranges } : chosen;
}

/** Each line with its mirror image, those along the middle once. */
const both = (primitives) =>
  primitives.flatMap((primitive) => {
    const points = primitive.points ?? primitive.spine;
    if (points.every(([x]) => Math.abs(x) < 0.004)) return [primitive];
    const flip = (line) => line.map(([x, y, z]) => [-x + 0, y, z]);
    const image = { ...primitive };
    for (const field of ['points', 'spine', 'section']) if (image[field]) image[field] = flip(image[field]);
    if (image.profiles) image.profiles = image.profiles.map(flip);
    if (image.tilt) image.tilt = image.tilt.map((x) => -x + 0);
    return [primitive, image];
  });

const recipe = (head, style) => ({
  lissom: 1,
  models: { [head]: { builtin: head } },
  steps: [{ id: 'hair 1', type: 'hair', model: head, ...style }],
});

/** Straight back from the brow, long behind. */
function smooth(hand) {
  const back = [
    [0.01, 0.2, -0.03],
    [0, 0.25, 0],
    [0, 0.25, 0.01],
  ];
  return {
    streams: both([
      hand.stream(
        hand.hang(
          hand.skin(
            [
              [0, 50],
              [0, 89],
              [180, 50],
              [180, 5],
            ],
            { lift: 0.04 },
          ),
          back,
        ),
      ),
      hand.stream(
        hand.hang(
          hand.skin(
            [
              [25, 46],
              [60, 75],
              [160, 40],
              [165, 0],
            ],
            { lift: 0.04 },
          ),
          back,
        ),
      ),
      hand.stream(
        hand.hang(
          hand.skin(
            [
              [52, 34],
              [90, 48],
              [140, 20],
              [150, -12],
            ],
            { lift: 0.04 },
          ),
          back,
        ),
      ),
      hand.stream(
        hand.hang(
          hand.skin(
            [
              [68, 8],
              [95, 22],
              [125, -2],
              [138, -24],
            ],
            { lift: 0.04 },
          ),
          back,
        ),
      ),
      hand.stream(
        hand.hang(
          hand.skin(
            [
              [150, -14],
              [152, -34],
            ],
            { lift: 0.03 },
          ),
          back,
        ),
      ),
    ]),
    length: { max: 0.25 },
    detail: { clump: 0.45, frizz: 0.15, flyaways: 0.01 },
    material: { melanin: 0.72, redness: 0.25 },
  };
}

/** Parted in the middle, falling to the shoulders on either side. */
function parted(hand) {
  const fall = [
    [0.02, 0.14, -0.01],
    [0.01, 0.2, 0],
    [0, 0.25, 0.01],
    [0, 0.2, 0.01],
  ];
  return {
    partings: [
      hand.parting([
        [0, 52],
        [0, 80],
        [180, 70],
      ]),
    ],
    streams: both([
      hand.stream(
        hand.hang(
          hand.skin(
            [
              [8, 54],
              [40, 42],
              [72, 14],
              [82, -10],
            ],
            { lift: 0.05 },
          ),
          fall,
        ),
      ),
      hand.stream(
        hand.hang(
          hand.skin(
            [
              [35, 80],
              [75, 52],
              [92, 18],
              [97, -12],
            ],
            { lift: 0.06 },
          ),
          fall,
        ),
      ),
      hand.stream(
        hand.hang(
          hand.skin(
            [
              [140, 80],
              [115, 46],
              [118, 10],
              [120, -16],
            ],
            { lift: 0.06 },
          ),
          fall,
        ),
      ),
      hand.stream(
        hand.hang(
          hand.skin(
            [
              [172, 66],
              [152, 36],
              [146, 4],
              [146, -20],
            ],
            { lift: 0.05 },
          ),
          fall,
        ),
      ),
      hand.stream(
        hand.hang(
          hand.skin(
            [
              [176, 30],
              [172, 0],
              [170, -24],
            ],
            { lift: 0.04 },
          ),
          fall,
        ),
      ),
    ]),
    length: { max: 0.27, variation: 0.3 },
    detail: { clump: 0.4, curl: 0.06, frizz: 0.2 },
    material: { melanin: 0.3, redness: 0.15, colorVariation: 0.35 },
  };
}

/** Chin long, parted at the side, turned in at the ends. */
function bob(hand) {
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
    partings: [
      hand.parting([
        [24, 50],
        [34, 72],
        [90, 82],
      ]),
    ],
    streams: [
      hand.stream(
        hand.hang(
          hand.skin(
            [
              [30, 52],
              [52, 40],
              [70, 12],
              [80, -14],
            ],
            full,
          ),
          beside,
        ),
      ),
      hand.stream(
        hand.hang(
          hand.skin(
            [
              [18, 54],
              [-30, 54],
              [-64, 24],
              [-80, -14],
            ],
            full,
          ),
          beside,
        ),
      ),
      hand.stream(
        hand.hang(
          hand.skin(
            [
              [50, 76],
              [84, 48],
              [96, 4],
            ],
            full,
          ),
          beside,
        ),
      ),
      hand.stream(
        hand.hang(
          hand.skin(
            [
              [20, 76],
              [-70, 66],
              [-92, 34],
              [-97, 2],
            ],
            full,
          ),
          beside,
        ),
      ),
      ...both([
        hand.stream(
          hand.hang(
            hand.skin(
              [
                [125, 78],
                [126, 36],
                [126, 0],
              ],
              full,
            ),
            beside,
          ),
        ),
        hand.stream(
          hand.hang(
            hand.skin(
              [
                [158, 76],
                [157, 36],
                [156, 0],
              ],
              full,
            ),
            behind,
          ),
        ),
        hand.stream(
          hand.hang(
            hand.skin(
              [
                [180, 76],
                [180, 36],
                [180, 0],
              ],
              full,
            ),
            behind,
          ),
        ),
      ]),
    ],
    length: { max: 0.25, variation: 0.05, map: hand.cutAt(0.07, 0.25) },
    volume: 0.012,
    detail: { clump: 0.35, frizz: 0.1, flyaways: 0.01 },
    material: { melanin: 0.92, redness: 0.1, colorVariation: 0.15 },
  };
}

/** Drawn back into one tail, high behind. */
function ponytail(hand) {
  const knot = hand.over([180, 34]);
  const [, y, z] = knot;
  const s = hand.size;
  const tail = [
    [0, y, z],
    [0, y + 0.03 * s, z - 0.1 * s],
    [0, y + 0.02 * s, z - 0.18 * s],
    [0, y - 0.06 * s, z - 0.26 * s],
    [0, y - 0.2 * s, z - 0.3 * s],
    [0, y - 0.4 * s, z - 0.3 * s],
    [0, y - 0.6 * s, z - 0.28 * s],
  ];
  const tied = { lift: 0.025 };
  return {
    streams: both([
      hand.stream(
        hand.skin(
          [
            [0, 50],
            [0, 88],
            [180, 48],
          ],
          tied,
        ),
      ),
      hand.stream(
        hand.skin(
          [
            [30, 46],
            [70, 66],
            [172, 44],
          ],
          tied,
        ),
      ),
      hand.stream(
        hand.skin(
          [
            [58, 28],
            [95, 44],
            [165, 36],
          ],
          tied,
        ),
      ),
      hand.stream(
        hand.skin(
          [
            [72, 4],
            [105, 18],
            [160, 28],
          ],
          tied,
        ),
      ),
      hand.stream(
        hand.skin(
          [
            [125, -16],
            [140, 4],
            [168, 24],
          ],
          tied,
        ),
      ),
      hand.stream(
        hand.skin(
          [
            [180, -46],
            [180, -10],
            [180, 22],
          ],
          tied,
        ),
      ),
      hand.stream(
        hand.skin(
          [
            [152, -44],
            [160, -12],
            [170, 20],
          ],
          tied,
        ),
      ),
      hand.stream(
        hand.skin(
          [
            [128, -36],
            [146, -8],
            [166, 20],
          ],
          tied,
        ),
      ),
    ]),
    ponytails: [hand.ponytail(tail, [0.075, 0.085, 0.095, 0.1], 0.7)],
    length: { max: 0.32 },
    volume: 0.005,
    detail: { clump: 0.5, curl: 0.05, frizz: 0.15 },
    material: { melanin: 0.42, redness: 0.8, colorVariation: 0.25 },
  };
}

/** Parted from brow to nape, a tail behind either ear. */
function pigtails(hand) {
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
    partings: [
      hand.parting([
        [0, 52],
        [0, 82],
        [180, 60],
        [180, 20],
        [180, -46],
      ]),
    ],
    streams: both([
      hand.stream(
        hand.skin(
          [
            [8, 52],
            [50, 40],
            [100, 10],
          ],
          tied,
        ),
      ),
      hand.stream(
        hand.skin(
          [
            [40, 80],
            [80, 56],
            [110, 18],
          ],
          tied,
        ),
      ),
      hand.stream(
        hand.skin(
          [
            [150, 76],
            [128, 48],
            [120, 18],
          ],
          tied,
        ),
      ),
      hand.stream(
        hand.skin(
          [
            [172, 40],
            [150, 26],
            [126, 10],
          ],
          tied,
        ),
      ),
      hand.stream(
        hand.skin(
          [
            [172, -10],
            [150, -8],
            [128, -2],
          ],
          tied,
        ),
      ),
      hand.stream(
        hand.skin(
          [
            [172, -44],
            [152, -28],
            [128, -8],
          ],
          tied,
        ),
      ),
      hand.stream(
        hand.skin(
          [
            [160, -56],
            [146, -36],
            [126, -10],
          ],
          tied,
        ),
      ),
      hand.stream(
        hand.skin(
          [
            [146, -46],
            [136, -28],
            [124, -8],
          ],
          tied,
        ),
      ),
      hand.stream(
        hand.skin(
          [
            [70, 4],
            [92, 6],
            [110, 4],
          ],
          tied,
        ),
      ),
    ]),
    ponytails: both([hand.ponytail(tail, [0.06, 0.07, 0.08, 0.075], 0.7)]),
    length: { max: 0.24 },
    volume: 0.005,
    detail: { clump: 0.5, curl: 0.1, frizz: 0.2 },
    material: { melanin: 0.2, redness: 0.1, colorVariation: 0.3 },
  };
}

/** Short and full of curls, away from the head all round. */
function curly(hand) {
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
}

/** Short at the sides, swept over from a parting at the side. */
function sidePart(hand) {
  const over = { lift: 0.05 };
  return {
    partings: [
      hand.parting(
        [
          [32, 50],
          [48, 66],
          [100, 74],
        ],
        [12, 0],
      ),
    ],
    streams: [
      hand.stream(
        hand.skin(
          [
            [28, 54],
            [-12, 60],
            [-46, 46],
            [-66, 30],
          ],
          over,
        ),
      ),
      hand.stream(
        hand.skin(
          [
            [60, 78],
            [-60, 76],
            [-84, 44],
            [-92, 22],
          ],
          over,
        ),
      ),
      hand.stream(
        hand.skin(
          [
            [120, 80],
            [-140, 74],
            [-118, 40],
            [-116, 12],
          ],
          over,
        ),
      ),
      hand.stream(
        hand.skin([
          [44, 48],
          [66, 28],
          [84, 8],
        ]),
      ),
      hand.stream(
        hand.skin([
          [80, 62],
          [96, 34],
          [108, 6],
        ]),
      ),
      hand.stream(
        hand.skin([
          [140, 66],
          [146, 30],
          [148, -8],
        ]),
      ),
      hand.stream(
        hand.skin([
          [-160, 60],
          [-165, 20],
          [-166, -16],
        ]),
      ),
      hand.stream(
        hand.skin([
          [-72, 16],
          [-98, 4],
          [-122, -12],
        ]),
      ),
    ],
    length: { max: 0.09, variation: 0.15 },
    volume: 0.012,
    detail: { clump: 0.5, frizz: 0.15, flyaways: 0.01 },
    material: { melanin: 0.62, redness: 0.3 },
  };
}

/** Very long and loosely waved, away from the face. */
function waves(hand) {
  const fall = [
    [0.02, 0.16, -0.03],
    [0.02, 0.25, -0.01],
    [0.01, 0.3, 0],
    [0, 0.3, 0.01],
  ];
  return {
    partings: [
      hand.parting([
        [0, 54],
        [0, 84],
      ]),
    ],
    streams: both([
      hand.stream(
        hand.hang(
          hand.skin(
            [
              [8, 58],
              [50, 56],
              [92, 30],
              [112, 0],
            ],
            { lift: 0.04 },
          ),
          fall,
        ),
      ),
      hand.stream(
        hand.hang(
          hand.skin(
            [
              [48, 84],
              [100, 62],
              [124, 24],
              [130, -8],
            ],
            { lift: 0.04 },
          ),
          fall,
        ),
      ),
      hand.stream(
        hand.hang(
          hand.skin(
            [
              [60, 30],
              [86, 26],
              [108, 2],
              [124, -20],
            ],
            { lift: 0.04 },
          ),
          fall,
        ),
      ),
      hand.stream(
        hand.hang(
          hand.skin(
            [
              [168, 76],
              [160, 40],
              [156, 4],
              [156, -18],
            ],
            { lift: 0.04 },
          ),
          fall,
        ),
      ),
      hand.stream(
        hand.hang(
          hand.skin(
            [
              [180, 40],
              [180, 4],
              [180, -22],
            ],
            { lift: 0.04 },
          ),
          fall,
        ),
      ),
    ]),
    length: { max: 0.36, variation: 0.3 },
    volume: 0.007,
    detail: { clump: 0.6, curl: 0.3, curlLength: 0.09, frizz: 0.2, flyaways: 0.01 },
    material: { melanin: 0.04, redness: 0, colorVariation: 0.15 },
  };
}

const STYLES = [
  ['hair-smooth', 'Swept back', 'head-female', smooth],
  ['hair-parted', 'Middle parting', 'head-female', parted],
  ['hair-bob', 'Bob', 'head-female', bob],
  ['hair-ponytail', 'Ponytail', 'head-female', ponytail],
  ['hair-pigtails', 'Two ponytails', 'head-elf', pigtails],
  ['hair-curly', 'Curls', 'head-male', curly],
  ['hair-side-part', 'Side parting', 'head-male', sidePart],
  ['hair-waves', 'Long waves', 'head-elf', waves],
];

/** @param folder  URL of public/gallery/ @returns name, title, model and recipe of each style */
export function hairExamples(folder) {
  const hands = new Map();
  return STYLES.map(([name, title, head, style]) => {
    if (!hands.has(head)) hands.set(head, new Hand(new URL(`${head}.ply`, folder)));
    return [name, title, head, recipe(head, style(hands.get(head)))];
  });
}
