// A file of a megabyte with one face of a hundred thousand corners kept its writer busy for a quarter of an hour, and the
// kernel for as long where the outline was a comb.

import { beforeAll, expect, test } from 'vitest';
import type { Model } from '../../web/core/model';
import { readModel, writeModel } from '../../web/io';
import type { KernelPort } from '../../web/kernel/contract';
import { loadKernel } from '../../web/kernel/node';
import { meter, refusal } from './bounded';

let kernel: KernelPort;
beforeAll(async () => {
  kernel = await loadKernel();
});

/** One straight side, and teeth on the other. */
function comb(n: number): Model {
  const positions = new Float64Array(3 * n);
  for (let i = 0; i < n; i++) positions.set(2 * i < n ? [i, 0, 0] : [n - 1 - i, i % 2 ? n / 2 : 1, 0], 3 * i);
  const faceVertices = Uint32Array.from({ length: n }, (_, i) => i);
  return { name: 'comb', positions, faceOffsets: Uint32Array.of(0, n), faceVertices };
}

test('a face of 30,000 corners is opened by the kernel and written as triangles', async () => {
  const model = comb(30_000);
  const written = meter('30,000 corners written as STL');
  expect(writeModel(model, 'stl').length).toBe(84 + 50 * 29_998);
  written();
  const opened = meter('30,000 corners opened by the kernel');
  const { triangles } = await kernel.call('openModel', model);
  opened();
  expect(triangles.length / 3).toBe(29_998);
});

test('a face of a million corners is refused by its number', () => {
  const file = writeModel(comb(1_000_000), 'ply');
  const { code, message } = refusal('1,000,000 corners', () => readModel(file, 'comb.ply'));
  expect(code).toBe('face-too-large');
  expect(message).toBe(
    'comb.ply: face 1 has 1,000,000 corners; the limit is 100,000. Cut it into smaller faces.',
  );
});
