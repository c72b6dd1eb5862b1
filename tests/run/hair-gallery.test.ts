// Every hairstyle of the gallery through the real kernel, held to what the hair is promised to be.

import { readdirSync, readFileSync } from 'node:fs';
import { beforeAll, describe, expect, test } from 'vitest';
import { FolderModels } from '../../web/cli/models';
import { Hasher } from '../../web/core/hash';
import type { Model } from '../../web/core/model';
import type { Strands } from '../../web/core/strands';
import { loadKernel } from '../../web/kernel/node';
import { decodeLink, encodeLink } from '../../web/recipe/link/link';
import { parseRecipe } from '../../web/recipe/parse';
import type { HairStep, Recipe } from '../../web/recipe/recipe';
import { Runner } from '../../web/run/evaluate';
import type { ReportOf, StepResult } from '../../web/run/results';
import { deepestInside, heightOf, partingCrossings, trianglesOf, type Vec } from './strand-measures';

const FOLDER = new URL('../../public/gallery/recipes/', import.meta.url);
const STYLES = readdirSync(FOLDER)
  .filter((file) => /^hair-.*\.json$/.test(file))
  .map((file) => file.replace('.json', ''));
/** Fewer than the styles have, by whole: the first ones of a style are the same whatever their count. */
const COUNT = 5000;
/** Of a head 24 cm high. */
const CENTIMETRE = 1 / 24;

const models = new FolderModels('.');

const recipeOf = (name: string): Recipe => parseRecipe(readFileSync(new URL(`${name}.json`, FOLDER), 'utf8'));

function hairOf(recipe: Recipe): HairStep {
  const step = recipe.steps.find(({ type }) => type === 'hair');
  if (step?.type !== 'hair') throw new Error('no hair in it');
  return step;
}

const withCount = (recipe: Recipe, count: number): Recipe => ({
  ...recipe,
  steps: recipe.steps.map((step) =>
    step.type === 'hair' ? { ...step, strands: { ...step.strands, count } } : step,
  ),
});

interface Grown {
  readonly step: HairStep;
  readonly model: Model;
  readonly strands: Strands;
  readonly report: ReportOf<'hair'>;
}

async function grow(recipe: Recipe): Promise<Grown> {
  const step = hairOf(recipe);
  const runner = new Runner({ kernel: await loadKernel(), models });
  const { model, strands, report } = (await runner.run(recipe)).get(step.id) as StepResult<'hair'>;
  return { step, model, strands: strands!, report };
}

const bytes = ({ offsets, points }: Strands): string => new Hasher().bytes(offsets).bytes(points).digest();

test('there are at least six styles on at least two heads', () => {
  const heads = STYLES.map((name) => Object.keys(recipeOf(name).models).join());
  expect(STYLES.length).toBeGreaterThanOrEqual(6);
  expect(new Set(heads).size).toBeGreaterThanOrEqual(2);
});

describe.each(STYLES)('%s', (name) => {
  const recipe = recipeOf(name);
  let grown: Grown;
  beforeAll(async () => {
    grown = await grow(withCount(recipe, COUNT));
  });

  test('no point lies deeper in the head than half a percent of its height', () => {
    const { model, strands, report } = grown;
    expect(report.insideHead).toBe(0);
    const most = 0.005 * heightOf(model);
    expect(deepestInside(strands, trianglesOf(model), most)).toBeLessThanOrEqual(most);
  });

  test('fewer than half a percent of the strands are stubs', () => {
    expect(Number(grown.report.shortStrands)).toBeLessThan(0.005 * COUNT);
  });

  test('no strand crosses a parting within its first centimetre', () => {
    const { step, model, strands } = grown;
    const height = heightOf(model);
    const triangles = trianglesOf(model);
    for (const { points } of step.partings) {
      const measured = partingCrossings(strands, points as Vec[], triangles, {
        reach: 3 * CENTIMETRE * height,
        first: CENTIMETRE * height,
      });
      expect(measured.near).toBeGreaterThan(100);
      expect(measured).toMatchObject({ crossing: 0 });
    }
  });

  test('each ponytail gathers 95 % of the strands rooted in its region', () => {
    const gathered = grown.report.gathered as number[];
    expect(gathered).toHaveLength(grown.step.ponytails.length);
    for (const share of gathered) expect(share).toBeGreaterThanOrEqual(0.95);
  });

  test('the link holds it whole, in under 2,000 characters', () => {
    const link = encodeLink(recipe, 'https://example.org/lissom/');
    console.info(`${name}: a link of ${link.length} characters`);
    expect(decodeLink(link)).toEqual(recipe);
    expect(encodeLink(decodeLink(link), 'https://example.org/lissom/')).toBe(link);
    expect(link.length).toBeLessThan(2000);
  });

  test('a kernel that starts afresh grows it byte for byte the same', async () => {
    expect(bytes((await grow(withCount(recipe, COUNT))).strands)).toBe(bytes(grown.strands));
  });
});
