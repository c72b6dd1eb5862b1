// The gallery's poses as they are given: nothing folded, nothing thinned out, feet on the ground.

import { existsSync, readFileSync } from 'node:fs';
import { beforeAll, describe, expect, test } from 'vitest';
import { toIndices } from '../../web/core/vertex-set';
import { readModel } from '../../web/io/formats';
import type { KernelPort } from '../../web/kernel/contract';
import { loadKernel } from '../../web/kernel/node';
import { parseRecipe } from '../../web/recipe/parse';
import type { TransferStep } from '../../web/recipe/recipe';
import { Runner } from '../../web/run/evaluate';
import type { StepResult } from '../../web/run/results';

const gallery = new URL('../../public/gallery/', import.meta.url);
const bytes = (file: string) => new Uint8Array(readFileSync(new URL(file, gallery)));
const { examples } = JSON.parse(new TextDecoder().decode(bytes('index.json'))) as {
  examples: { name: string; file: string; workspace: string }[];
};
const given = examples.filter(({ workspace }) => workspace === 'transfer');

let kernel: KernelPort;
beforeAll(async () => {
  kernel = await loadKernel();
});

test('there are some, each with a picture', () => {
  expect(given.length).toBeGreaterThanOrEqual(4);
  for (const { name } of given) expect(existsSync(new URL(`thumbnails/${name}.webp`, gallery))).toBe(true);
});

describe.each(given)('$name', ({ file }) => {
  const recipe = parseRecipe(new TextDecoder().decode(bytes(file)));
  const step = recipe.steps.at(-1) as TransferStep;
  let result: StepResult<'transfer'>;
  beforeAll(async () => {
    const models = {
      load: async (name: string) => readModel(bytes(`${name}.ply`), `${name}.ply`).model,
    };
    const results = await new Runner({ kernel, models }).run(recipe, { measure: true });
    result = results.get(step.id) as StepResult<'transfer'>;
  });

  test('every handle has its counterpart, and nothing is to be said', () => {
    const known = result.inputs[0]!.opened.findings;
    expect(result.report.warnings.filter((each) => !known.includes(each))).toEqual([]);
    expect(result.report.unknowns).toBeGreaterThan(0);
  });

  test('the surface is as whole as it was', () => {
    const { volumeRatio, flippedTriangles, edgeRms } = result.measured!;
    if (!step.model.startsWith('head')) {
      expect(volumeRatio).toBeGreaterThan(0.9);
      expect(volumeRatio).toBeLessThan(1.1);
    }
    expect(flippedTriangles).toBe(0);
    expect(edgeRms).toBeLessThan(0.13);
  });

  test('what stays in the pose stays here', () => {
    const pose = recipe.steps[0]!;
    if (pose.type !== 'deform') throw new Error('not a pose');
    const rest = result.inputs[0]!.model.positions;
    const height =
      Math.max(...rest.filter((_, i) => i % 3 === 1)) - Math.min(...rest.filter((_, i) => i % 3 === 1));
    for (const [i, handle] of pose.handles.entries()) {
      if (handle.kind !== 'region' || handle.matrix.some((x, k) => x !== (k % 5 === 0 ? 1 : 0))) continue;
      const set = toIndices(step.handles[i]!, rest.length / 3);
      const off = [...set].map((v) =>
        Math.hypot(...[0, 1, 2].map((k) => result.model.positions[3 * v + k]! - rest[3 * v + k]!)),
      );
      expect(Math.max(...off) / height).toBeLessThan(0.03);
    }
  });
});
