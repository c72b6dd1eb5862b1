// What must hold exactly of a deformation (algorithm notes 1, a to d), through the whole of the command line:
// file in, WebAssembly, file out. Distances in fractions of the model's diagonal.

import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import type { Model } from '../../web/core/model';
import { ball, diagonal, gap, renumbered, sheet, shuffle, together, torus, transformed } from './shapes';
import { deformRecipe, region, Shell } from './shell';

const TOLERANCE = 1e-6;

interface Case {
  readonly model: Model;
  /** Vertices of the handles; each component has some. */
  readonly handles: readonly (readonly number[])[];
  /** Vertex of a point handle. */
  readonly point: number;
}

const range = (first: number, last: number) => Array.from({ length: last - first + 1 }, (_, i) => first + i);

const two = together(ball(10, 12), sheet(9, 8));
const onBall = 2 + 9 * 12;

const CASES: Readonly<Record<string, Case>> = {
  'a sheet with a boundary': { model: sheet(14, 10), handles: [range(0, 10), range(154, 164)], point: 80 },
  'a closed ball': { model: ball(14, 16), handles: [range(0, 16), range(200, 209)], point: 110 },
  'a torus of genus 1': { model: torus(24, 10), handles: [range(0, 9), range(120, 129)], point: 65 },
  'two components, one of them open': {
    model: two,
    handles: [
      range(0, 12),
      range(onBall - 9, onBall - 1),
      range(onBall, onBall + 8),
      range(onBall + 80, onBall + 89),
    ],
    point: onBall + 45,
  },
};

const angle = fc.double({ min: -3, max: 3, noNaN: true });
const entry = fc.double({ min: -0.5, max: 0.5, noNaN: true });
const shift = fc.tuple(entry, entry, entry);

/** A scale, turns about all three axes, a shift. */
const anySimilarity = fc
  .tuple(fc.double({ min: 0.4, max: 2.5, noNaN: true }), fc.tuple(angle, angle, angle), shift)
  .map(([scale, angles, by]) => similarity(scale, angles, by));

/** Near enough the identity to keep its orientation, far enough to shear and stretch. */
const anyAffine = fc.tuple(fc.tuple(shift, shift, shift), shift).map(([columns, by]) => {
  const stretched = columns.map((column, at) => column.map((x, row) => (row === at ? x + 1.6 : x)));
  return matrixOf(stretched, by);
});

const SIMILARITY = similarity(1.3, [0.4, -0.3, 0.5], [0.4, -0.2, 0.3]);

function similarity(
  scale: number,
  [a, b, c]: readonly [number, number, number],
  by: readonly number[],
): number[] {
  const axes = [
    [scale, 0, 0],
    [0, scale, 0],
    [0, 0, scale],
  ] as const;
  return matrixOf(
    axes.map(([x, y, z]) => {
      const [y1, z1] = [y * Math.cos(a) - z * Math.sin(a), y * Math.sin(a) + z * Math.cos(a)];
      const [x2, z2] = [x * Math.cos(b) + z1 * Math.sin(b), z1 * Math.cos(b) - x * Math.sin(b)];
      return [x2 * Math.cos(c) - y1 * Math.sin(c), x2 * Math.sin(c) + y1 * Math.cos(c), z2];
    }),
    by,
  );
}

function matrixOf(columns: readonly (readonly number[])[], by: readonly number[]): number[] {
  return [...columns.flatMap((column) => [...column, 0]), ...by, 1];
}

/** The same maps in every run; few, for each is a whole run of the command. */
const RUNS = { seed: 20070316, numRuns: 5 };

/** The recipe in which every handle follows one map. */
function common({ model, handles, point }: Case, matrix: readonly number[], step: object) {
  const position = [...transformed(model, matrix).slice(3 * point, 3 * point + 3)];
  const all = [
    ...handles.map((vertices) => region(vertices, matrix)),
    { kind: 'point', vertices: [point], position },
  ];
  return deformRecipe(all, step);
}

async function result(recipe: object, model: Model): Promise<Model> {
  const shell = new Shell();
  expect(await shell.run(recipe, { 'm.ply': model })).toEqual({ status: 0, stdout: '', stderr: '' });
  return shell.model('out/o.ply');
}

describe.each(Object.entries(CASES))('%s', (_, given) => {
  const { model } = given;
  const unit = diagonal(model);

  test.each([1, 2])(
    'without shear removal, handles under one affine map take the model along (ring %i)',
    async (ring) => {
      const options = { removeShear: false, coherenceRing: ring };
      await fc.assert(
        fc.asyncProperty(anyAffine, async (affine) => {
          const { positions } = await result(common(given, affine, { options }), model);
          expect(gap(positions, transformed(model, affine)) / unit).toBeLessThan(TOLERANCE);
        }),
        RUNS,
      );
    },
  );

  test.each(['implicit', 'iterative'])(
    'with shear removed and details scaled, one similarity takes the model along (%s)',
    async (method) => {
      const options = { removeShear: true, scaleDetails: true, iterations: method === 'iterative' ? 3 : 1 };
      await fc.assert(
        fc.asyncProperty(anySimilarity, async (any) => {
          const { positions } = await result(common(given, any, { method, options }), model);
          expect(gap(positions, transformed(model, any)) / unit).toBeLessThan(TOLERANCE);
        }),
        RUNS,
      );
    },
  );

  test.each(['implicit', 'iterative', 'naive'])(
    'handles at rest leave the model as it is (%s)',
    async (method) => {
      const recipe = deformRecipe(
        given.handles.map((vertices) => region(vertices)),
        { method },
      );
      const { positions } = await result(recipe, model);
      expect(gap(positions, model.positions) / unit).toBeLessThan(TOLERANCE);
    },
  );

  test('other vertex numbers change the order and nothing else', async () => {
    const order = shuffle(model.positions.length / 3);
    const bent = (number: (v: number) => number) => {
      const [held, ...moved] = given.handles.map((vertices) => vertices.map(number));
      return deformRecipe([region(held), ...moved.map((vertices) => region(vertices, SIMILARITY))]);
    };
    const plain = await result(
      bent((v) => v),
      model,
    );
    const shuffled = await result(
      bent((v) => order[v]!),
      renumbered(model, order),
    );
    expect(gap(plain.positions, model.positions) / unit).toBeGreaterThan(0.05);
    expect(gap(shuffled.positions, renumbered(plain, order).positions) / unit).toBeLessThan(TOLERANCE);
  });

  test('the same recipe gives the same bytes', async () => {
    const recipe = common(given, SIMILARITY, { options: { removeShear: true } });
    const [first, second] = [await result(recipe, model), await result(recipe, model)];
    expect(first.positions).toEqual(second.positions);
  });
});
