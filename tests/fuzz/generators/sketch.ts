// Strokes, regions, lines and views on small models, by the real kernel.

import type { KernelPort } from '../../../web/kernel/contract';
import { loadKernel } from '../../../web/kernel/node';
import { bar, type Shape, sheet } from '../../kernel/shapes';
import { type Generator, must, outcomeOf } from '../generator';
import type { Random } from '../random';

let kernel: Promise<KernelPort> | undefined;
let calls = 0;

const SHAPES: readonly Shape[] = [bar(12, 3), sheet(9, 7)];
const ODD = [0, -1, 1e-30, 1e30, Number.NaN, Number.POSITIVE_INFINITY];

/** A number that is mostly sensible. */
const number = (random: Random, low: number, high: number) =>
  random.chance(0.003) ? random.pick(ODD) : random.between(low, high);

function inputOf(random: Random) {
  const places = random.few(40);
  const list = (count: number, low: number, high: number) =>
    Float64Array.from(random.list(count, () => number(random, low, high)));
  const line = () => list(3 * random.few(8) + (random.chance(0.03) ? 1 : 0), -2, 14);
  return {
    shape: random.pick(SHAPES),
    pixels: list(2 * places, 0, 300),
    origins: list(3 * (random.chance(0.05) ? places + 1 : places), -2, 14),
    directions: list(3 * places, -1, 1),
    kind: random.pick(['automatic', 'skeleton', 'surface'] as const),
    line: line(),
    others: random.list(random.below(3), line),
    radius: number(random, 0, 5),
    kappa: number(random, 0.5, 3),
    eye: [number(random, -9, 9), number(random, -9, 9), number(random, -9, 9)] as const,
    perspective: random.chance(0.5),
  };
}

const sketch: Generator = {
  kind: 'sketch and lines',
  every: 10,
  calls: () => calls,
  show: (random) => JSON.stringify(inputOf(random)),
  async run(random) {
    kernel ??= loadKernel();
    const port = await kernel;
    const ask: KernelPort['call'] = (method, args, options) => {
      calls++;
      return port.call(method, args, options);
    };
    const { shape, pixels, origins, directions, kind, line, others, radius, kappa, eye, perspective } =
      inputOf(random);
    const { id: model } = await ask('openModel', shape);
    const { id: on } = await ask('prepareSketch', { model });
    const { id: contours } = await ask('prepareContours', { model, sweeps: random.below(4) });
    const finite = (numbers: ArrayLike<number>) =>
      must(Array.from(numbers).every(Number.isFinite), 'no number');
    try {
      const outcomes = [
        await outcomeOf(async () => {
          const curve = await ask('sketchCurve', {
            sketch: on,
            pixels,
            origins,
            directions,
            options: { kind },
          });
          finite(curve.points);
          finite(curve.radius);
          await ask('curveRegion', {
            sketch: on,
            points: curve.points,
            options: { hits: curve.hits, kappa },
          });
        }),
        await outcomeOf(() => ask('curveRegion', { sketch: on, points: line })),
        await outcomeOf(async () =>
          finite((await ask('lineWeights', { sketch: on, line, others, radius })).weights),
        ),
        await outcomeOf(async () =>
          finite((await ask('contourLines', { contours, view: { perspective, eye } })).points),
        ),
      ];
      return outcomes.find((outcome) => outcome !== 'accepted') ?? 'accepted';
    } finally {
      for (const id of [contours, on, model]) await ask('release', { id });
    }
  },
};
export default sketch;
