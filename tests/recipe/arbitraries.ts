// Random valid recipes, for properties that must hold for all of them.

import fc from 'fast-check';
import { IDENTITY } from '../../web/core/affine';
import { MAX_COORDINATE } from '../../web/recipe/limits';
import { parseRecipe } from '../../web/recipe/parse';
import type { Recipe } from '../../web/recipe/recipe';

// The same recipes in every run.
fc.configureGlobal({ seed: 20070316 });

/** Every sort of number a document may hold: short decimals, single precision, any double, −0. */
export const anyNumber = fc.oneof(
  fc.integer({ min: -1000, max: 1000 }),
  fc.integer({ min: -100_000, max: 100_000 }).map((n) => n / 1000),
  fc.float({ noNaN: true, noDefaultInfinity: true }),
  fc.double({ noNaN: true, noDefaultInfinity: true }),
  fc.constantFrom(-0, Number.MAX_VALUE, Number.MIN_VALUE, Number.MAX_SAFE_INTEGER, 2 ** 60, 1e-7, 0.1 + 0.2),
);

/** As far out as a recipe's coordinates go. */
const coordinate = anyNumber.map((n) => (Math.abs(n) > MAX_COORDINATE ? n % MAX_COORDINATE : n));
const point = fc.tuple(coordinate, coordinate, coordinate);
const index = fc.oneof(fc.nat(5000), fc.nat(Number.MAX_SAFE_INTEGER));

const matrix = fc.tuple(point, point, point, point).map((columns) => {
  return columns.flatMap((column, at) => [...column, at === 3 ? 1 : 0]);
});

const vertexSet = fc.oneof(
  fc.constant('all' as const),
  fc.array(index, { maxLength: 30 }),
  fc.array(fc.tuple(index, fc.nat(300)), { maxLength: 10 }).map((pairs) => ({
    ranges: pairs.map(([first, length]) => [first, Math.min(first + length, Number.MAX_SAFE_INTEGER)]),
  })),
);

const label = {
  name: fc.string({ unit: 'binary', maxLength: 20 }),
  hidden: fc.boolean(),
};

const handle = fc.oneof(
  fc.record(
    { kind: fc.constant('region'), vertices: vertexSet, matrix, ...label },
    { requiredKeys: ['kind', 'vertices', 'matrix'] },
  ),
  fc.record(
    { kind: fc.constant('point'), vertices: fc.tuple(index), position: point, ...label },
    { requiredKeys: ['kind', 'vertices', 'position'] },
  ),
);

const step = fc.record(
  {
    handles: fc.array(handle, { maxLength: 4 }),
    roi: vertexSet,
    method: fc.constantFrom('implicit', 'iterative', 'naive'),
    options: fc.record(
      {
        removeShear: fc.boolean(),
        scaleDetails: fc.boolean(),
        iterations: fc.integer({ min: 1, max: 100 }),
        coherenceRing: fc.constantFrom(1, 2),
      },
      { requiredKeys: [] },
    ),
    from: fc.nat(),
  },
  { requiredKeys: ['handles', 'from'] },
);

const builtins = ['dinosaur', 'horse', 'head-female', 'something-new-7'];
const modelNames = fc.uniqueArray(fc.stringMatching(/^[\p{L}\p{N}][\p{L}\p{N} ._-]{0,10}$/u), {
  minLength: 1,
  maxLength: 3,
});

/** As documents are written, defaults left out; always valid. */
export const anyDocument = fc
  .record({
    names: modelNames,
    steps: fc.array(step, { maxLength: 4 }),
    ids: fc.nat(),
    outputs: fc.boolean(),
  })
  .map(({ names, steps, ids, outputs }) => {
    const models = Object.fromEntries(
      names.map((name, at) => [name, { builtin: builtins[(at + ids) % 4]! }]),
    );
    const known = Object.keys(models);
    const made = steps.map(({ from, ...fields }, at) => {
      const model = known[from % known.length]!;
      const id = `${'step é\n'.slice(0, 1 + (ids % 7))}${at} ${names[0]}`;
      known.push(id);
      return { id, type: 'deform', model, ...fields };
    });
    const files = made.map(({ id }, at) => ({ step: id, file: `o${at}.${at % 2 ? 'ply' : 'GLB'}` }));
    return { lissom: 1, models, steps: made, ...(outputs ? { outputs: files } : {}) };
  });

export const anyRecipe: fc.Arbitrary<Recipe> = anyDocument.map((document) => parseRecipe(document));

/** The example of the recipe's description, on a built-in model. */
export const example = () => ({
  lissom: 1,
  models: { bar: { builtin: 'bar' } },
  steps: [
    {
      id: 'bend',
      type: 'deform',
      model: 'bar',
      roi: 'all',
      handles: [
        { kind: 'region', vertices: { ranges: [[0, 80]] }, matrix: IDENTITY },
        { kind: 'region', vertices: [1950, 1951], matrix: [1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 2, 1, 1] },
        { kind: 'point', vertices: [977], position: [0.1, 0.4, 2] },
      ],
      method: 'implicit',
      options: { removeShear: true, scaleDetails: false, iterations: 1, coherenceRing: 1 },
    },
  ],
  outputs: [{ step: 'bend', file: 'bent.ply' }],
});
