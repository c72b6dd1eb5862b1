// Blends and garments through the bridge, on the real kernel: skins of one connectivity made by formula.

import { beforeAll, describe, expect, test } from 'vitest';
import type { KernelPort } from '../../web/kernel/contract';
import type { MeasureSpec } from '../../web/kernel/contract/wear';
import { loadKernel } from '../../web/kernel/node';
import { ball, belt } from './balls';

let kernel: KernelPort;
beforeAll(async () => {
  kernel = await loadKernel();
});

const slim = ball(20, 24, (x, y, z) => [x, 2 * y, z]);
const stout = ball(20, 24, (x, y, z) => [1.6 * x, 1.5 * y, 1.4 * z]);
const skins = { triangles: slim.faceVertices, positions: [slim.positions, stout.positions] };
const top = Uint32Array.from({ length: 49 }, (_, vertex) => vertex);
const height: MeasureSpec = { kind: 'height', up: [0, 1, 0] };
/** A vertex at the waist. */
const waist: MeasureSpec = { kind: 'section', vertex: slim.ends[0]!, normal: [0, 1, 0], hull: true };

const blend = async (parts: readonly object[], weights: number[], measures: readonly MeasureSpec[] = []) => {
  const prepared = await kernel.call('prepareBlend', { ...skins, parts: parts as never });
  const blended = await kernel.call('blend', {
    blend: prepared.id,
    weights: Float64Array.from(weights),
    measures,
  });
  await kernel.call('release', { id: prepared.id });
  return blended;
};

test('weights make a sum, and measures are read off it', async () => {
  const { positions, reached, weights, iterations } = await blend([], [0.25, 0.75], [height, waist]);
  for (let at = 0; at < positions.length; at += 17)
    expect(positions[at]).toBeCloseTo(0.25 * slim.positions[at]! + 0.75 * stout.positions[at]!, 12);
  expect(reached[0]).toBeCloseTo(3.25, 9);
  expect(reached[1]).toBeGreaterThan(2 * Math.PI * 1.3);
  expect([...weights]).toEqual([0.25, 0.75]);
  expect(iterations).toBe(0);
});

test('a wanted measure finds weights that sum to one', async () => {
  const { weights, reached } = await blend([], [1, 0], [{ ...height, value: 3.4 }, waist]);
  expect(reached[0]).toBeCloseTo(3.4, 3);
  expect(weights[0]! + weights[1]!).toBeCloseTo(1, 12);
  expect(weights[1]).toBeCloseTo(0.6, 3);
});

test('a part takes the shape of another and leaves the rest', async () => {
  const part = { from: 1, vertices: top, feather: 0.3, how: 'paste' };
  const plain = await blend([part], [1, 0]);
  const last = slim.positions.length - 1;
  expect(plain.positions[last]).toBe(slim.positions[last]);
  expect(plain.positions[1]).not.toBeCloseTo(slim.positions[1]!, 3);
  const whole = await blend([part], [0, 1]);
  for (let at = 0; at < whole.positions.length; at += 7)
    expect(whole.positions[at]).toBeCloseTo(stout.positions[at]!, 7);
});

describe('dressing', () => {
  const garment = belt(1.05);
  const dress = async (offset: number) => {
    const opened = await kernel.call('openModel', garment);
    const model = await kernel.call('openModel', stout);
    const prepared = await kernel.call('prepareDress', {
      garment: opened.id,
      triangles: slim.faceVertices,
      from: slim.positions,
      to: stout.positions,
      model: model.id,
    });
    // What a session needs it keeps.
    await kernel.call('release', { id: opened.id });
    await kernel.call('release', { id: model.id });
    const dressed = await kernel.call('dress', { dress: prepared.id, offset });
    await kernel.call('release', { id: prepared.id });
    return dressed;
  };

  test('nothing stays inside, whatever the ease', async () => {
    for (const offset of [0, 0.1, -0.05]) {
      const { positions, after } = await dress(offset);
      expect(after.vertices).toBe(0);
      expect(positions).toHaveLength(garment.positions.length);
      expect(positions.every(Number.isFinite)).toBe(true);
    }
  });

  test('more ease is wider', async () => {
    const width = ({ positions }: { positions: Float64Array }) =>
      positions.reduce((most, x, at) => (at % 3 === 0 ? Math.max(most, x) : most), 0);
    expect(width(await dress(0.1)) - width(await dress(0))).toBeCloseTo(0.1, 1);
  });
});

describe('poses through skins', () => {
  const give = async (pose: Float64Array, strength = 1, keepStretch = false) => {
    const source = await kernel.call('openModel', slim);
    const target = await kernel.call('openModel', stout);
    const prepared = await kernel.call('prepareTransferThrough', {
      source: source.id,
      target: target.id,
      triangles: slim.faceVertices,
      from: slim.positions,
      to: stout.positions,
    });
    expect(prepared.unknowns).toBe(slim.positions.length / 3);
    // What a session needs it keeps.
    await kernel.call('release', { id: source.id });
    await kernel.call('release', { id: target.id });
    const args = { transfer: prepared.id, pose, strength, keepStretch };
    const given = await kernel.call('transferThrough', args).finally(() => {
      return kernel.call('release', { id: prepared.id });
    });
    return given;
  };
  const sheared = slim.positions.map((x, at) => (at % 3 === 0 ? x + 0.3 * slim.positions[at + 1]! : x));

  test('at rest the other stays at rest', async () => {
    const { positions, iterations } = await give(slim.positions);
    for (let at = 0; at < positions.length; at++) expect(positions[at]).toBeCloseTo(stout.positions[at]!, 9);
    expect(iterations).toBeGreaterThan(0);
  });

  test('a shear of one is a shear of the other, where stretch is kept', async () => {
    const { positions, iterations } = await give(sheared, 1, true);
    expect(iterations).toBe(1);
    const [tip, foot] = [0, positions.length - 3];
    const lean = positions[tip]! - positions[foot]! - (stout.positions[tip]! - stout.positions[foot]!);
    expect(lean).toBeCloseTo(0.3 * (stout.positions[tip + 1]! - stout.positions[foot + 1]!), 0);
    const half = await give(sheared, 0.5, true);
    expect(half.positions[tip]! - half.positions[foot]!).toBeLessThan(positions[tip]! - positions[foot]!);
  });

  test.each<[string, () => Promise<unknown>]>([
    ['wrong-size', () => give(slim.positions.slice(3))],
    ['bad-option', () => give(slim.positions, Number.NaN)],
    ['non-finite-position', () => give(slim.positions.map((x, at) => (at === 4 ? Number.NaN : x)))],
  ])('%s', async (code, work) => {
    await expect(work()).rejects.toMatchObject({ code, fault: 'input' });
  });
});

test.each<[string, () => Promise<unknown>]>([
  ['empty-part', () => blend([{ from: 0, vertices: new Uint32Array(), how: 'paste' }], [1, 0])],
  ['whole-part', () => blend([{ from: 0, vertices: slim.faceVertices, how: 'paste' }], [1, 0])],
  ['vertex-out-of-range', () => blend([{ from: 0, vertices: Uint32Array.of(9999), how: 'paste' }], [1, 0])],
  ['bad-option', () => blend([{ from: 0, vertices: top, how: 'glue' }], [1, 0])],
  ['no-weights', () => blend([], [0, 0])],
  ['wrong-size', () => blend([], [1])],
  ['loop-open', () => blend([], [1, 0], [{ ...waist, vertex: 0 } as MeasureSpec])],
])('%s', async (code, work) => {
  await expect(work()).rejects.toMatchObject({ code, fault: 'input' });
});
