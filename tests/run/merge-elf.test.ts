// A head of the gallery on another body: an opening on one side, a painted region on the other.

import { readFileSync } from 'node:fs';
import { beforeAll, expect, test } from 'vitest';
import { type Model, vertexCount } from '../../web/core/model';
import { readModel } from '../../web/io/formats';
import type { KernelPort } from '../../web/kernel/contract';
import { loadKernel } from '../../web/kernel/node';
import { parseRecipe } from '../../web/recipe/parse';
import { Runner } from '../../web/run/evaluate';
import type { StepResult } from '../../web/run/results';
import { affine, transformed } from '../kernel/shapes';

let kernel: KernelPort;
beforeAll(async () => {
  kernel = await loadKernel();
});

const load = (name: string): Model =>
  readModel(readFileSync(new URL(`../../public/gallery/${name}.ply`, import.meta.url)), `${name}.ply`).model;

type Test = (x: number, y: number, z: number) => boolean;
const where = ({ positions }: Model, holds: Test): number[] =>
  Array.from({ length: positions.length / 3 }, (_, v) => v).filter((v) =>
    holds(positions[3 * v]!, positions[3 * v + 1]!, positions[3 * v + 2]!),
  );
/** The vertex that lies farthest along z. */
const front = ({ positions }: Model, vertices: readonly number[]): number =>
  vertices.reduce((best, v) => (positions[3 * v + 2]! > positions[3 * best + 2]! ? v : best));

async function loopOf(model: Model, region: readonly number[]): Promise<number[]> {
  const { positions, faceOffsets, faceVertices } = model;
  const opened = await kernel.call('openModel', { positions, faceOffsets, faceVertices });
  const loops = await kernel.call('loopsAround', {
    model: opened.id,
    vertices: Uint32Array.from(region),
  });
  await kernel.call('release', { id: opened.id });
  return [...loops.reduce((longest, loop) => (loop.length > longest.length ? loop : longest))];
}

/** The edge of a head's open neck, in order. */
function neckOf({ faceOffsets, faceVertices }: Model): number[] {
  const next = new Map<number, number>();
  const inner = new Set<string>();
  for (let f = 0; f + 1 < faceOffsets.length; f++)
    for (let k = faceOffsets[f]!; k < faceOffsets[f + 1]!; k++) {
      const to = faceVertices[k + 1 < faceOffsets[f + 1]! ? k + 1 : faceOffsets[f]!]!;
      inner.add(`${faceVertices[k]} ${to}`);
    }
  for (const edge of inner) {
    const [a, b] = edge.split(' ').map(Number) as [number, number];
    if (!inner.has(`${b} ${a}`)) next.set(a, b);
  }
  const loop = [next.keys().next().value!];
  for (let v = next.get(loop[0]!)!; v !== loop[0]; v = next.get(v)!) loop.push(v);
  return loop;
}

async function merge(source: Model, target: Model, step: object) {
  const models: Record<string, Model> = { source, target };
  const recipe = parseRecipe({
    lissom: 1,
    models: { source: { file: 'source.ply' }, target: { file: 'target.ply' } },
    steps: [{ id: 'm', type: 'merge', source: 'source', target: 'target', ...step }],
  });
  const runner = new Runner({ kernel, models: { load: async (name) => models[name]! } });
  const { model, report } = (await runner.run(recipe)).get('m') as StepResult<'merge'>;
  return { model, report, seam: report.seam };
}

test('an elf gets the head it always wanted, wherever the head lay before', async () => {
  const head = load('head-elf');
  const body = load('body-female');
  const neck = neckOf(head);
  const keep = where(body, (_, y) => y < 1.33);
  const cut = await loopOf(body, keep);
  const boundary = {
    source: neck,
    target: cut,
    targetKeep: keep,
    keys: [[front(head, neck), front(body, cut)]],
  };
  const { model, report, seam } = await merge(head, body, { boundaries: [boundary] });
  expect(report.eulerCharacteristic).toBe(2);
  expect(seam.highDihedral).toBeLessThan(Math.max(20, seam.ownHighDihedral));
  expect(seam.leastAngle).toBeGreaterThan(1);
  expect(vertexCount(model)).toBeGreaterThan(vertexCount(head));

  const turned = affine(
    [
      [0, -30, 0],
      [30, 0, 0],
      [0, 0, 30],
    ],
    [7, -5, 11],
  );
  const far = { ...head, positions: Float64Array.from(transformed(head.positions, turned)) };
  const again = await merge(far, body, { boundaries: [boundary] });
  const gap = model.positions.reduce(
    (most, x, k) => Math.max(most, Math.abs(x - again.model.positions[k]!)),
    0,
  );
  expect(gap).toBeLessThan(1e-6 * 1.57);
});
