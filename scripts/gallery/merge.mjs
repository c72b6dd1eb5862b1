// The gallery's merged models: where they are to meet is picked by geometry, as a hand would paint it. Written by
// scripts/gallery.mjs.

import { modelOf } from './models.mjs';
import { setOf } from './vertex-set.mjs';

/** Directions along which a vertex can lie farthest. */
const [UP, DOWN, FRONT, BACK] = [
  [0, 1, 0],
  [0, -1, 0],
  [0, 0, 1],
  [0, 0, -1],
];

class Shape {
  constructor(model) {
    Object.assign(this, model);
  }

  where(inside) {
    return this.points.flatMap((p, v) => (inside(...p) ? [v] : []));
  }

  near(point, radius) {
    return this.where((...p) => Math.hypot(...p.map((x, k) => x - point[k])) < radius);
  }

  /** Of some vertices (all by default) the one farthest along a direction. */
  most(direction, vertices = [...this.points.keys()]) {
    const far = (v) => this.points[v].reduce((sum, x, k) => sum + x * direction[k], 0);
    return vertices.reduce((best, v) => (far(v) > far(best) ? v : best));
  }

  /** The edges of the faces that lie in the region as closed paths, each with the region to its left. */
  loops(inside = () => true) {
    const edges = new Map();
    for (const face of this.faces)
      if (face.every((v) => inside(...this.points[v])))
        for (const [c, v] of face.entries())
          edges.set(`${v} ${face[(c + 1) % face.length]}`, [v, face[(c + 1) % face.length]]);
    const next = new Map();
    for (const [a, b] of edges.values()) if (!edges.has(`${b} ${a}`)) next.set(a, b);
    const loops = [];
    for (const start of next.keys()) {
      const loop = [];
      for (let v = start; next.has(v); ) {
        loop.push(v);
        const to = next.get(v);
        next.delete(v);
        v = to;
      }
      if (loop.length > 0) loops.push(loop);
    }
    return loops;
  }

  /** The longest edge of a region. */
  around(inside) {
    return this.loops(inside).reduce((a, b) => (b.length > a.length ? b : a));
  }
}

const recipe = (source, target, step) => ({
  lissom: 1,
  models: { [source]: { builtin: source }, [target]: { builtin: target } },
  steps: [{ id: 'merge 1', type: 'merge', source, target, ...step }],
  outputs: [],
});

/** A man from the waist up where the horse's neck was. */
function centaur(shape) {
  const [man, horse] = [shape('body-male'), shape('horse')];
  const legs = (x, y) => y < 1.06 && Math.abs(x) < 0.27;
  const neck = (_x, y, z) => (y - 1.4) * 0.96 + (z - 0.62) * 0.28 > 0;
  const [waist, chest] = [man.around(legs), horse.around(neck)];
  return recipe('body-male', 'horse', {
    boundaries: [
      {
        source: waist,
        sourceKeep: [man.most(UP)],
        target: chest,
        targetKeep: [horse.most(BACK)],
        keys: [
          [man.most(FRONT, waist), horse.most(FRONT, chest)],
          [man.most(BACK, waist), horse.most(BACK, chest)],
        ],
      },
    ],
    smoothing: 4,
  });
}

/** A dinosaur with wings: both are one model of two pieces. */
function dragon(shape) {
  const [wings, dinosaur] = [shape('wings'), shape('dinosaur')];
  const roots = wings.loops();
  const boundaries = [-1, 1].map((side) => {
    const root = roots.find((loop) => Math.sign(wings.points[loop[0]][0]) === side);
    const shoulder = dinosaur.around((x, y, z) => Math.hypot(x - 0.25 * side, y - 1.28, z - 0.32) < 0.22);
    return {
      source: root,
      target: shoulder,
      targetKeep: [dinosaur.most(FRONT)],
      keys: [
        [wings.most(FRONT, root), dinosaur.most(FRONT, shoulder)],
        [wings.most(BACK, root), dinosaur.most(BACK, shoulder)],
      ],
    };
  });
  return recipe('wings', 'dinosaur', { boundaries, smoothing: 4 });
}

/** Pipes with four equal branches on cylinders of four sizes and heights. */
function engine(shape) {
  const [pipes, block] = [shape('pipes'), shape('block')];
  const byX = (from) => (a, b) => from.points[a[0]][0] - from.points[b[0]][0];
  const openings = block.loops().sort(byX(block));
  const boundaries = pipes
    .loops()
    .sort(byX(pipes))
    .map((source, k) => ({
      source,
      target: openings[k],
      keys: [
        [pipes.most(FRONT, source), block.most(FRONT, openings[k])],
        [pipes.most(BACK, source), block.most(BACK, openings[k])],
      ],
    }));
  return recipe('pipes', 'block', { boundaries, smoothing: 2 });
}

/** A cow to be wound up: its key has two holes. */
function clockwork(shape) {
  const [key, cow] = [shape('key'), shape('cow')];
  return recipe('key', 'cow', {
    optimalBoundary: {
      sourceRegion: 'all',
      feature: setOf(key.where((_x, y) => y > 0.03)),
      targetRegion: setOf(cow.where((x, y, z) => x > 0 && y > 0.6 && Math.hypot(y - 1.05, z + 0.05) < 0.5)),
      placement: { shift: [0, 0], turn: 220, scale: 0.74 },
    },
    smoothing: 2,
  });
}

/** A horse that lives in the sea: its head looks out of an octopus. */
function seaHorse(shape) {
  const [horse, octopus] = [shape('horse'), shape('octopus')];
  const crown = octopus.points[octopus.most(UP)];
  const muzzle = horse.points[horse.most(UP)];
  return recipe('horse', 'octopus', {
    optimalBoundary: {
      sourceRegion: setOf(horse.near(muzzle, 0.9)),
      feature: setOf(horse.near(muzzle, 0.42)),
      targetRegion: setOf(octopus.where((x, y, z) => Math.hypot(x, y - crown[1], z + 0.25) < 0.56)),
      placement: { shift: [0, 0], turn: 40, scale: 0.73 },
    },
    smoothing: 2,
  });
}

/** The bull's head on a man's shoulders. */
function minotaur(shape) {
  const [cow, man] = [shape('cow'), shape('body-male')];
  const head = (_x, y, z) => (y - 1.2) * 0.7 + (z - 0.86) * 0.7 > 0;
  const face = (_x, y, z) => (y - 1.53) * 0.73 + (z - 0.03) * 0.68 > 0;
  const [nape, neck] = [cow.around(head), man.around(face)];
  return recipe('cow', 'body-male', {
    boundaries: [
      {
        source: nape,
        sourceKeep: [cow.most(FRONT)],
        target: neck,
        targetKeep: [man.most(DOWN)],
        keys: [
          [cow.most(UP, nape), man.most(UP, neck)],
          [cow.most(DOWN, nape), man.most(DOWN, neck)],
        ],
      },
    ],
    smoothing: 4,
  });
}

const EXAMPLES = [
  ['merge-centaur', 'Centaur', 'horse', centaur],
  ['merge-dragon', 'Dragon', 'dinosaur', dragon],
  ['merge-engine', 'Engine', 'block', engine],
  ['merge-clockwork', 'Clockwork cow', 'cow', clockwork],
  ['merge-minotaur', 'Minotaur', 'body-male', minotaur],
  ['merge-sea-horse', 'Sea horse', 'octopus', seaHorse],
];

/** @returns name, title, model and recipe of each example */
export function mergeExamples() {
  const shapes = new Map();
  const shape = (name) => {
    if (!shapes.has(name)) shapes.set(name, new Shape(modelOf(name)));
    return shapes.get(name);
  };
  return EXAMPLES.map(([name, title, model, make]) => [name, title, model, make(shape)]);
}
