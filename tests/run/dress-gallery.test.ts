// The gallery's clothes on the real kernel: nothing of them is inside who wears them. Of the scans it is known whom they were
// made of, so that they are held to that and not to the skin that they were fitted by.

import { existsSync, readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { faceCount, type Model, vertexCount } from '../../web/core/model';
import { readModel } from '../../web/io/formats';
import { loadKernel } from '../../web/kernel/node';
import { parseRecipe } from '../../web/recipe/parse';
import type { DressStep, Recipe } from '../../web/recipe/recipe';
import { Runner } from '../../web/run/evaluate';
import type { StepResult } from '../../web/run/results';
import { clearances } from '../../web/tools/dress/clearance';

const gallery = new URL('../../public/gallery/', import.meta.url);
const bytes = (file: string) => new Uint8Array(readFileSync(new URL(file, gallery)));
const read = (name: string): Model => readModel(bytes(`${name}.ply`), `${name}.ply`).model;
const { examples } = JSON.parse(new TextDecoder().decode(bytes('index.json'))) as {
  examples: { name: string; file: string; workspace: string }[];
};
const given = examples.filter(({ workspace }) => workspace === 'dress');
/** What scans were made of. */
const CLEAN: Readonly<Record<string, string>> = { 'body-soup': 'body-male', 'body-points': 'body-heavy' };
/** Metres: the noise of a scan, and what its skin is off. */
const SCAN_ERROR = 0.004;

test('there are some, each with a picture', () => {
  expect(given.length).toBeGreaterThanOrEqual(4);
  for (const { name } of given) expect(existsSync(new URL(`thumbnails/${name}.webp`, gallery))).toBe(true);
});

test('the soup is one, the points are points', () => {
  const soup = read('body-soup');
  expect(vertexCount(soup)).toBe(3 * faceCount(soup));
  const places = new Set(
    Array.from({ length: vertexCount(soup) }, (_, v) => soup.positions.subarray(3 * v, 3 * v + 3).join()),
  );
  expect(places.size).toBe(vertexCount(soup));
  expect(faceCount(read('body-points'))).toBe(0);
});

/** Each garment of a recipe on everybody who is dressed in it: what would not be seen under something else fits as well. */
function withAll(recipe: Recipe): Recipe {
  const steps = recipe.steps.filter((step): step is DressStep => step.type === 'dress');
  const more = [...new Set(steps.map(({ garment }) => garment))].flatMap((garment) =>
    [...new Set(steps.map(({ to }) => to))]
      .filter((to) => !steps.some((step) => step.garment === garment && step.to === to))
      .map((to): DressStep => ({ ...steps[0]!, id: `${garment} ${to}`, garment, to, offset: 0 })),
  );
  return { ...recipe, steps: [...recipe.steps, ...more] };
}

describe.each(given)('$name', ({ file }) => {
  test('nothing is inside of who wears it', { timeout: 600_000 }, async () => {
    const recipe = withAll(parseRecipe(new TextDecoder().decode(bytes(file))));
    const models = { load: async (name: string) => read(name) };
    const results = await new Runner({ kernel: await loadKernel(), models }).run(recipe);
    const steps = recipe.steps.filter((step): step is DressStep => step.type === 'dress');
    expect(steps.length).toBeGreaterThan(0);
    for (const { id, to } of steps) {
      const { model, report } = results.get(id) as StepResult<'dress'>;
      expect(report, id).toMatchObject({ inside: 0, insideCentres: 0 });
      const told = report.warnings.some(({ code }) => code === 'model-without-inside');
      expect(told, id).toBe(to === 'body-points');
      if (!CLEAN[to]) continue;
      const clean = read(CLEAN[to]!);
      const deepest = clearances(model.positions, clean.positions, clean.faceVertices).reduce((a, b) =>
        Math.min(a, b),
      );
      expect(deepest, id).toBeGreaterThan(-SCAN_ERROR);
    }
  });
});
