// The gallery's examples of the isoline method through the real kernel: handles met, nothing folded, and what each is there
// to show.

import { existsSync, readFileSync } from 'node:fs';
import { beforeAll, describe, expect, test } from 'vitest';
import { type Model, vertexCount } from '../../web/core/model';
import { toIndices } from '../../web/core/vertex-set';
import { type BuiltIn, builtInAtOnce } from '../../web/io/built-in';
import type { KernelPort } from '../../web/kernel/contract';
import { loadKernel } from '../../web/kernel/node';
import { decodeLink, encodeLink } from '../../web/recipe/link/link';
import { parseRecipe } from '../../web/recipe/parse';
import type { DeformStep, Recipe } from '../../web/recipe/recipe';
import { Runner } from '../../web/run/evaluate';
import type { StepResult } from '../../web/run/results';

const gallery = new URL('../../public/gallery/', import.meta.url);
const bytes = (file: string) => new Uint8Array(readFileSync(new URL(file, gallery)));
const index = JSON.parse(new TextDecoder().decode(bytes('index.json'))) as {
  models: (BuiltIn & { vertices: number })[];
  examples: { name: string; file: string; model: string }[];
};
const read = new Map<string, Model>();
function modelOf(name: string): Model {
  const entry = index.models.find((each) => each.name === name)!;
  if (!read.has(name)) read.set(name, builtInAtOnce(entry, bytes(entry.file)).model);
  return read.get(name)!;
}

const given = index.examples
  .map((example) => ({ ...example, recipe: parseRecipe(new TextDecoder().decode(bytes(example.file))) }))
  .filter(({ recipe }) => deformOf(recipe)?.method === 'isolines');

function deformOf({ steps }: Recipe): DeformStep | undefined {
  const last = steps.at(-1);
  return last?.type === 'deform' ? last : undefined;
}

const results = new Map<string, StepResult<'deform'>>();
let kernel: KernelPort;
beforeAll(async () => {
  kernel = await loadKernel();
  const runner = new Runner({
    kernel,
    models: { load: async (_, ref) => modelOf((ref as { builtin: string }).builtin) },
  });
  for (const { name, recipe } of given) {
    const all = await runner.run(recipe, { measure: true });
    results.set(name, all.get(recipe.steps.at(-1)!.id) as StepResult<'deform'>);
  }
}, 300_000);

test('there is a large model, one with holes, the bar three times, and a face twice', () => {
  expect(given.map(({ name }) => name)).toEqual([
    'critter-scaled-dancing',
    'loops-rearing',
    'bar-by-isolines',
    'bar-by-10-hats',
    'bar-by-20-hats',
    'face-happy',
    'face-sad',
  ]);
});

describe.each(given)('$name', ({ name, recipe, model }) => {
  const step = deformOf(recipe)!;

  test('has a picture, as its model has', () => {
    for (const of of [name, model]) expect(existsSync(new URL(`thumbnails/${of}.webp`, gallery))).toBe(true);
  });

  test('goes whole into a link, its model by its name', () => {
    const { models } = decodeLink(encodeLink(recipe, 'https://lissom.test/'));
    expect(models).toEqual({ [model]: { builtin: model } });
  });

  test('every handle is where it is asked for, and nothing is to be said', () => {
    const { report, inputs, model: posed } = results.get(name)!;
    const known = inputs[0]!.opened.findings;
    expect(report.warnings.filter((each) => !known.includes(each))).toEqual([]);
    const rest = inputs[0]!.model.positions;
    const size = Math.max(...[0, 1, 2].map((k) => spreadOf(rest, k)));
    for (const handle of step.handles)
      for (const v of toIndices(handle.vertices, vertexCount(posed))) {
        const [x, y, z] = rest.subarray(3 * v, 3 * v + 3) as unknown as [number, number, number];
        for (let k = 0; k < 3; k++) {
          const wanted =
            handle.kind === 'point'
              ? handle.position[k]!
              : handle.matrix[k]! * x +
                handle.matrix[4 + k]! * y +
                handle.matrix[8 + k]! * z +
                handle.matrix[12 + k]!;
          if (!(Math.abs(posed.positions[3 * v + k]! - wanted) < 1e-9 * size))
            expect.fail(`${handle.name} is off at vertex ${v}`);
        }
      }
  });

  test('the surface is as whole as it was', () => {
    const { volumeRatio, flippedTriangles } = results.get(name)!.measured!;
    expect(flippedTriangles).toBe(0);
    if (results.get(name)!.inputs[0]!.opened.closed) {
      expect(volumeRatio).toBeGreaterThan(0.93);
      expect(volumeRatio).toBeLessThan(1.05);
    }
  });
});

function spreadOf(positions: Float64Array, axis: number): number {
  let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (let i = axis; i < positions.length; i += 3) {
    low = Math.min(low, positions[i]!);
    high = Math.max(high, positions[i]!);
  }
  return high - low;
}

test('the large one is large, and follows by four handles', () => {
  const { model, report } = results.get('critter-scaled-dancing')!;
  expect(vertexCount(model)).toBeGreaterThan(300_000);
  expect(report.settled).toBe(false);
  expect(deformOf(given[0]!.recipe)!.handles).toHaveLength(4);
});

test('the loops are one piece with four holes', () => {
  const { opened, model } = results.get('loops-rearing')!.inputs[0]!;
  const edges = new Set<number>();
  const { faceVertices } = model;
  for (let c = 0; c < faceVertices.length; c++) {
    const [a, b] = [faceVertices[c]!, faceVertices[c - (c % 3) + ((c + 1) % 3)]!];
    edges.add(Math.min(a, b) * vertexCount(model) + Math.max(a, b));
  }
  expect([opened.components, opened.closed]).toEqual([1, true]);
  expect(vertexCount(model) - edges.size + faceVertices.length / 3).toBe(2 - 2 * 4);
});

test('the bar differs by its controls: twenty straight ones come nearer to the smooth ones than ten', () => {
  const at = (name: string) => results.get(name)!.model.positions;
  const gap = (name: string) => {
    const [a, b] = [at(name), at('bar-by-isolines')];
    return Math.max(
      ...Array.from({ length: a.length / 3 }, (_, v) =>
        Math.hypot(...[0, 1, 2].map((k) => a[3 * v + k]! - b[3 * v + k]!)),
      ),
    );
  };
  expect(gap('bar-by-20-hats')).toBeGreaterThan(1e-4);
  expect(gap('bar-by-10-hats')).toBeGreaterThan(gap('bar-by-20-hats'));
  const unknowns = ['bar-by-10-hats', 'bar-by-20-hats'].map((name) => results.get(name)!.report.unknowns!);
  expect(unknowns[1]).toBeGreaterThan(unknowns[0]!);
});

test('twelve handles hold a face, two regions and ten points; the corners of its mouth go up and down', () => {
  for (const [name, sign] of [
    ['face-happy', 1],
    ['face-sad', -1],
  ] as const) {
    const { handles } = deformOf(given.find((each) => each.name === name)!.recipe)!;
    expect(handles.map(({ kind }) => kind).sort()).toEqual([...Array(10).fill('point'), 'region', 'region']);
    const { model, inputs } = results.get(name)!;
    for (const corner of handles.filter((each) => each.name?.includes('mouth corner'))) {
      const v = (corner.vertices as readonly number[])[0]!;
      expect(sign * (model.positions[3 * v + 1]! - inputs[0]!.model.positions[3 * v + 1]!)).toBeGreaterThan(
        0.005,
      );
    }
  }
});
