// Transfer through the bridge, on the real kernel: what holds whatever the method is.

import { beforeAll, describe, expect, test } from 'vitest';
import type { Args, KernelPort } from '../../web/kernel/contract';
import { loadKernel } from '../../web/kernel/node';
import { affine, allVertices, bar, diagonal, gap, type Shape, transformed, verticesWhere } from './shapes';

let kernel: KernelPort;
beforeAll(async () => {
  kernel = await loadKernel();
});

const LENGTH = 16;
/** A bar, and one of another size, thickness and mesh; both along x. */
const source = bar(LENGTH, 2);
const target = scaled(bar(2 * LENGTH, 6), 0.25);
const ends = (shape: Shape): readonly Uint32Array[] => {
  const length = shape.positions.reduce((most, x, at) => (at % 3 === 0 ? Math.max(most, x) : most), 0);
  const end = length / 10;
  return [verticesWhere(shape, (x) => x <= end), verticesWhere(shape, (x) => x >= length - end)];
};

function scaled(shape: Shape, by: number): Shape {
  return { ...shape, positions: shape.positions.map((x) => by * x) };
}

/** The source with its far end turned by degrees about z, as the deform steps bend it. */
async function bent(degrees: number): Promise<Float64Array> {
  const angle = (degrees * Math.PI) / 180;
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  // The end of an arc that is as long as the bar.
  const radius = degrees === 0 ? 0 : LENGTH / angle;
  const [x, y] = degrees === 0 ? [LENGTH, 0] : [radius * s, radius * (1 - c)];
  const turned = affine(
    [
      [c, -s, 0],
      [s, c, 0],
      [0, 0, 1],
    ],
    [x - c * LENGTH, y - s * LENGTH, 0],
  );
  const still = affine(
    [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ],
    [0, 0, 0],
  );
  const { id: model } = await kernel.call('openModel', source);
  const handles = ends(source).map((vertices) => ({ kind: 'region' as const, vertices }));
  const options = {};
  const deform = await kernel.call('prepareDeform', { model, roi: allVertices(source), handles, options });
  const { positions } = await kernel.call('deform', {
    deform: deform.id,
    targets: Float64Array.from([...still, ...turned]),
  });
  await kernel.call('release', { id: deform.id });
  await kernel.call('release', { id: model });
  return positions;
}

type Options = Partial<Pick<Args<'transfer'>, 'strength' | 'keepStretch'>>;

async function given(to: Shape, pose: Float64Array, options: Options = {}, held = ends(to)) {
  const models = [await kernel.call('openModel', source), await kernel.call('openModel', to)] as const;
  const prepared = await kernel.call('prepareTransfer', {
    source: models[0].id,
    sourceHandles: ends(source),
    target: models[1].id,
    targetHandles: held,
  });
  const asked = { transfer: prepared.id, pose, strength: 1, keepStretch: false, ...options };
  const transferred = await kernel.call('transfer', asked);
  const again = await kernel.call('transfer', asked);
  const measured = await kernel.call('measure', { model: models[1].id, positions: transferred.positions });
  for (const { id } of [prepared, ...models]) await kernel.call('release', { id });
  expect(again.positions).toEqual(transferred.positions);
  return { prepared, ...transferred, measured };
}

/** By how much the far end has turned about z against the near one, in degrees. */
function turnOf(shape: Shape, positions: Float64Array): number {
  const across = (set: Uint32Array, x: number) => {
    const rest = shape.positions;
    const at = [...set].filter((v) => Math.abs(rest[3 * v]! - x) < 1e-9);
    const low = at.reduce((a, b) => (rest[3 * b + 1]! < rest[3 * a + 1]! ? b : a));
    const high = at.reduce(
      (a, b) => (rest[3 * b + 1]! > rest[3 * a + 1]! && rest[3 * b + 2] === rest[3 * low + 2] ? b : a),
      low,
    );
    return Math.atan2(
      positions[3 * high + 1]! - positions[3 * low + 1]!,
      positions[3 * high]! - positions[3 * low]!,
    );
  };
  const [near, far] = ends(shape) as [Uint32Array, Uint32Array];
  const length = Math.max(...shape.positions.filter((_, at) => at % 3 === 0));
  const turn = ((across(far, length) - across(near, 0)) * 180) / Math.PI;
  return turn < -180 ? turn + 360 : turn;
}

test('a bar of another mesh and size bends as far as the first one', async () => {
  const { positions, measured, prepared, iterations } = await given(target, await bent(90));
  // It is thicker for its length: its ends are drawn to where the other's ends went.
  expect(turnOf(target, positions)).toBeGreaterThan(80);
  expect(turnOf(target, positions)).toBeLessThan(95);
  expect(measured.volumeRatio).toBeGreaterThan(0.9);
  expect(measured.volumeRatio).toBeLessThan(1.1);
  expect(measured.flippedTriangles).toBe(0);
  expect(prepared.unknowns).toBeGreaterThan(0);
  expect(iterations).toBeGreaterThan(0);
});

test('at rest, and without strength, the target stays as it is', async () => {
  for (const [pose, options] of [
    [source.positions, {}],
    [await bent(60), { strength: 0 }],
  ] as const)
    for (const keepStretch of [false, true]) {
      const { positions } = await given(target, pose, { ...options, keepStretch });
      expect(gap(positions, target.positions)).toBeLessThan(1e-9);
    }
});

test('half the strength bends half as far', async () => {
  const pose = await bent(90);
  const half = await given(target, pose, { strength: 0.5 });
  expect(turnOf(target, half.positions)).toBeCloseTo(45, -1);
});

test('neither the size of the models nor where they stand matters', async () => {
  const pose = await bent(70);
  const first = await given(target, pose);
  for (const [by, move] of [
    [1e-3, 0],
    [1e3, 0],
    [1, 50],
  ] as const) {
    const map = affine(
      [
        [by, 0, 0],
        [0, by, 0],
        [0, 0, by],
      ],
      [move, 2 * move, -move],
    );
    const other = { ...target, positions: transformed(target.positions, map) };
    const held = ends(target);
    const { positions } = await given(other, pose, {}, held);
    expect(gap(positions, transformed(first.positions, map))).toBeLessThan(1e-6);
  }
});

test('a model that is turned as a whole turns the other', async () => {
  const turn = affine(
    [
      [0, -1, 0],
      [1, 0, 0],
      [0, 0, 1],
    ],
    [0, 0, 0],
  );
  const { positions } = await given(target, transformed(source.positions, turn));
  const wanted = transformed(target.positions, turn);
  // Its ends go as far as the other's, in shares of diagonals, which are not the same share of a thicker bar's length.
  const off = [0, 1, 2].map((axis) => positions[axis]! - wanted[axis]!);
  const shifted = wanted.map((x, at) => x + off[at % 3]!);
  expect(gap(positions, shifted)).toBeLessThan(0.03);
  const itself = await given(source, transformed(source.positions, turn));
  expect(gap(itself.positions, transformed(source.positions, turn))).toBeLessThan(1e-9);
});

test('kept stretch lengthens the other as well, and is not kept unless asked for', async () => {
  const long = source.positions.map((x, at) => (at % 3 === 0 ? 1.4 * x : x));
  const length = (positions: Float64Array) => diagonal(positions) / diagonal(target.positions);
  expect(length((await given(target, long, { keepStretch: true })).positions)).toBeGreaterThan(1.3);
  // The ends are drawn apart all the same.
  expect(length((await given(target, long)).positions)).toBeLessThan(1.2);
});

describe('what cannot be paired is refused', () => {
  const all = allVertices(target);
  test.each<[string, readonly Uint32Array[]]>([
    ['fewer counterparts than handles', [ends(target)[0]!]],
    ['an empty counterpart', [ends(target)[0]!, new Uint32Array()]],
    ['counterparts that share vertices', [ends(target)[0]!, all]],
    ['a vertex that is not there', [ends(target)[0]!, Uint32Array.of(all.length)]],
  ])('%s', async (_, held) => {
    const pose = source.positions;
    await expect(given(target, pose, {}, held)).rejects.toMatchObject({
      fault: 'input',
      message: expect.stringMatching(/^[A-Z].{20,}\.$/),
    });
  });

  test('a pose of another model', async () => {
    await expect(given(target, target.positions)).rejects.toMatchObject({ fault: 'input' });
  });
});

test('preparing can be cancelled, and nothing is left behind', async () => {
  const abort = new AbortController();
  const models = [await kernel.call('openModel', source), await kernel.call('openModel', target)] as const;
  const asked = kernel.call(
    'prepareTransfer',
    { source: models[0].id, sourceHandles: ends(source), target: models[1].id, targetHandles: ends(target) },
    { signal: abort.signal },
  );
  abort.abort();
  await expect(asked).rejects.toMatchObject({ fault: 'cancelled' });
});
