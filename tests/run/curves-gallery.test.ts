// The gallery's examples of curves through the real kernel: nothing crosses itself more than at rest, and each does what it
// is there to show.

import { existsSync, readFileSync } from 'node:fs';
import { beforeAll, describe, expect, test } from 'vitest';
import { FolderModels } from '../../web/cli/models';
import { loadKernel } from '../../web/kernel/node';
import { decodeLink, encodeLink } from '../../web/recipe/link/link';
import { parseRecipe } from '../../web/recipe/parse';
import type { CurvesStep, Recipe } from '../../web/recipe/recipe';
import { takePose } from '../../web/recipe/steps/curves-poses';
import { Runner } from '../../web/run/evaluate';
import type { StepResult } from '../../web/run/results';

const gallery = new URL('../../public/gallery/', import.meta.url);
const text = (file: string) => readFileSync(new URL(file, gallery), 'utf8');
const { examples } = JSON.parse(text('index.json')) as {
  examples: { name: string; file: string; model: string; workspace: string }[];
};
const given = examples
  .filter(({ workspace }) => workspace === 'curves')
  .map((example) => ({ ...example, recipe: parseRecipe(text(example.file)) }));

function stepOf({ steps }: Recipe): CurvesStep {
  const step = steps.at(-1);
  if (step?.type !== 'curves') throw new Error('no curves in it');
  return step;
}

let runner: Runner;
const results = new Map<string, StepResult<'curves'>>();

async function posed(recipe: Recipe): Promise<StepResult<'curves'>> {
  const all = await runner.run(recipe, { measure: true });
  return all.get(stepOf(recipe).id) as StepResult<'curves'>;
}

beforeAll(async () => {
  runner = new Runner({ kernel: await loadKernel(), models: new FolderModels('.') });
  for (const { name, recipe } of given) results.set(name, await posed(recipe));
}, 300_000);

type Point = [number, number, number];
const pointAt = (positions: Float64Array, v: number) =>
  [...positions.subarray(3 * v, 3 * v + 3)] as unknown as Point;
const gap = (a: readonly number[], b: readonly number[]) => Math.hypot(...a.map((x, k) => x - b[k]!));

/** An example's vertices at rest and as posed. */
function vertices(name: string): { readonly rest: Point; readonly now: Point }[] {
  const { inputs, model } = results.get(name)!;
  const rest = inputs[0]!.model.positions;
  return Array.from({ length: rest.length / 3 }, (_, v) => ({
    rest: pointAt(rest, v),
    now: pointAt(model.positions, v),
  }));
}
/** What rests is moved by the identity, to rounding. */
const STILL = 1e-12;
const farthest = (list: readonly { rest: Point; now: Point }[]) =>
  list.reduce((most, { rest, now }) => Math.max(most, gap(rest, now)), 0);

test('there are limbs, bodies, a walk, a face and what is no manifold', () => {
  expect(given.map(({ name }) => name)).toEqual([
    'curves-octopus',
    'curves-cactus',
    'curves-horse',
    'curves-body-cheering',
    'curves-body-balancing',
    'curves-body-walking',
    'curves-ears',
    'curves-brow',
    'curves-bar',
    'curves-moebius',
    'curves-sheets',
    'curves-snake',
  ]);
});

describe.each(given)('$name', ({ name, recipe, model }) => {
  test('has a picture, as its model has', () => {
    for (const of of [name, model]) expect(existsSync(new URL(`thumbnails/${of}.webp`, gallery))).toBe(true);
  });

  test('goes whole into a link, its model by its name', () => {
    const link = encodeLink(recipe, 'https://lissom.test/');
    expect(decodeLink(link)).toEqual(recipe);
    expect(recipe.models).toEqual({ [model]: { builtin: model } });
    expect(link.length).toBeLessThan(stepOf(recipe).poses.length > 0 ? 4000 : 2000);
  });

  test('nothing crosses itself more than at rest, and nothing is to be said', () => {
    const { report, inputs } = results.get(name)!;
    const known = inputs[0]!.opened.findings;
    expect(report.warnings.filter((each) => !known.includes(each))).toEqual([]);
    const { before, after } = report.selfIntersections!;
    expect(after).toBeLessThanOrEqual(before);
    expect(report.tilt).toBeLessThan(30);
  });

  test('no face is turned over, and what is closed keeps its volume', () => {
    const { measured, inputs } = results.get(name)!;
    expect(measured!.flippedTriangles).toBe(0);
    if (!inputs[0]!.opened.closed) return;
    expect(measured!.volumeRatio).toBeGreaterThan(0.93);
    expect(measured!.volumeRatio).toBeLessThan(1.07);
  });
});

test('the octopus rolls up its arms, and its head stays', () => {
  const list = vertices('curves-octopus');
  expect(farthest(list.filter(({ rest }) => rest[1] > 0.7))).toBeLessThan(STILL);
  expect(farthest(list)).toBeGreaterThan(0.8);
});

test('bones of the horse stay straight: their vertices keep their distances', () => {
  const shank = vertices('curves-horse').filter(
    ({ rest: [x, y, z] }) => x > 0 && y > 0.3 && y < 0.46 && z > 0.4,
  );
  expect(shank.length).toBeGreaterThan(100);
  expect(farthest(shank)).toBeGreaterThan(0.15);
  for (const a of shank.slice(0, 20))
    for (const b of shank)
      expect(Math.abs(gap(a.now, b.now) - gap(a.rest, b.rest))).toBeLessThan(0.01 * 0.426);
});

describe('the walk', () => {
  const { recipe } = given.find(({ name }) => name === 'curves-body-walking')!;
  const step = stepOf(recipe);

  test('is a round: its last pose is its first', () => {
    expect(step.poses.at(-1)!.curves).toEqual(step.poses[0]!.curves);
    const times = step.poses.map(({ time }) => time!);
    expect(times).toEqual([...times].sort((a, b) => a - b));
  });

  test('keeps a foot on the ground, and the surface whole, in every pose', async () => {
    for (const pose of step.poses) {
      const { model, report, measured, inputs } = await posed({ ...recipe, steps: [takePose(step, pose)] });
      const heights = (positions: Float64Array) => positions.filter((_, i) => i % 3 === 1);
      const low = (positions: Float64Array) => heights(positions).reduce((a, b) => Math.min(a, b));
      const rest = inputs[0]!.model.positions;
      const tall = heights(rest).reduce((a, b) => Math.max(a, b)) - low(rest);
      expect(Math.abs(low(model.positions) - low(rest)) / tall).toBeLessThan(0.01);
      expect(report.selfIntersections!.after).toBeLessThanOrEqual(report.selfIntersections!.before);
      expect(measured!.flippedTriangles).toBe(0);
    }
  });
});

test('the tips of the ears are drawn out, the head stays', () => {
  const list = vertices('curves-ears');
  expect(farthest(list.filter(({ rest }) => Math.abs(rest[0]) < 0.07))).toBeLessThan(STILL);
  expect(farthest(list)).toBeGreaterThan(0.03);
});

test('the brow is raised; the other one, the mouth and the skull stay', () => {
  const list = vertices('curves-brow');
  const height = 0.272;
  expect(farthest(list)).toBeGreaterThan(0.02 * height);
  const still = list.filter(({ rest: [x, y, z] }) => x < -0.025 || y < 0.13 || z < 0.05);
  expect(farthest(still)).toBeLessThan(STILL);
});

test('what meets at the seam of the one-sided band still meets there', () => {
  const list = vertices('curves-moebius');
  const rows = list.length / 21;
  expect(Number.isInteger(rows)).toBe(true);
  for (let j = 0; j <= 20; j++) {
    const [first, last] = [list[j]!, list[21 * (rows - 1) + (20 - j)]!];
    expect(gap(first.rest, last.rest)).toBeLessThan(1e-6);
    expect(gap(first.now, last.now)).toBeLessThan(1e-6);
  }
  expect(farthest(list)).toBeGreaterThan(0.5);
});

test('of three sheets two bend, the third and the edge stay', () => {
  const list = vertices('curves-sheets');
  const edge = list.filter(({ rest: [x, , z] }) => Math.hypot(x, z) < 1e-6);
  const third = list.filter(({ rest: [x, , z] }) => Math.hypot(x, z) > 1e-6 && x > 0.5 * Math.hypot(x, z));
  expect(edge.length).toBeGreaterThan(20);
  expect(third.length).toBeGreaterThan(1000);
  expect(farthest([...edge, ...third])).toBeLessThan(STILL);
  expect(farthest(list)).toBeGreaterThan(0.5);
});

test('both pieces of the snake follow one curve, and the gap between them stays as wide', () => {
  const { opened } = results.get('curves-snake')!.inputs[0]!;
  expect([opened.components, opened.closed]).toEqual([2, true]);
  const list = vertices('curves-snake');
  const cut = (x: number) => list.filter(({ rest }) => Math.abs(rest[0] - x) < 0.01);
  const middle = (of: typeof list) =>
    [0, 1, 2].map((k) => of.reduce((sum, { now }) => sum + now[k]! / of.length, 0));
  const wide = gap(middle(cut(0.52)), middle(cut(0.68)));
  expect(wide).toBeGreaterThan(0.14);
  expect(wide).toBeLessThan(0.18);
});
