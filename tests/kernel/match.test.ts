// Matches through the bridge, on the real kernel: what holds whatever the method is.

import { beforeAll, describe, expect, test } from 'vitest';
import type { Args, CallOptions, KernelPort, Look } from '../../web/kernel/contract';
import { loadKernel } from '../../web/kernel/node';
import { type Ball, pear, plum, pointsOf } from './balls';

let kernel: KernelPort;
beforeAll(async () => {
  kernel = await loadKernel();
});

const none = { ignored: new Uint32Array(), curves: [], sharp: [] };
const opened = async (shape: Ball) => (await kernel.call('openModel', shape)).id;

async function matched(
  shapes: readonly Ball[],
  options: Args<'match'>['options'] = {},
  call: CallOptions = {},
  marked = (shape: Ball) => pointsOf(shape, shape.ends),
) {
  const models = [];
  for (const shape of shapes) models.push({ model: await opened(shape), markers: marked(shape), ...none });
  try {
    return await kernel.call('match', { models, options: { edgeLength: 0.25, ...options } }, call);
  } finally {
    for (const { model } of models) await kernel.call('release', { id: model });
  }
}

describe('two bodies', () => {
  test('get one connectivity, lie on their models and hold their markers', async () => {
    const [source, target] = [pear(), plum()];
    const found = await matched([source, target]);
    const count = found.positions[0]!.length / 3;
    expect(found.positions[1]).toHaveLength(3 * count);
    expect(Math.max(...found.triangles)).toBe(count - 1);
    for (const { distance, flipped, selfIntersections } of found.figures) {
      expect(distance.mean).toBeLessThan(0.003);
      expect(distance.back).toBeLessThan(0.003);
      expect(distance.p99).toBeLessThan(0.012);
      expect([flipped, selfIntersections]).toEqual([0, 0]);
    }
    expect(found.markerError).toBeLessThan(1e-9);
    for (const [at, shape] of [source, target].entries())
      for (const [marker, vertex] of found.markerVertices.entries()) {
        const place = pointsOf(shape, [shape.ends[marker]!]);
        const there = found.positions[at]!.subarray(3 * vertex, 3 * vertex + 3);
        expect(Math.hypot(...place.map((x, axis) => x - there[axis]!))).toBeLessThan(1e-9);
      }
  });

  test('are matched alike every time, byte for byte', async () => {
    const [once, again] = [await matched([pear(), plum()]), await matched([pear(), plum()])];
    expect(again.triangles).toEqual(once.triangles);
    expect(again.positions).toEqual(once.positions);
  });

  test('are seen growing, and the match ends where nobody waits for it', async () => {
    const looks: Look[] = [];
    await matched([pear(), plum()], {}, { onLook: (look) => looks.push(look) });
    for (const { triangles, positions } of looks) {
      expect(positions).toHaveLength(2);
      expect(Math.max(...triangles)).toBeLessThan(positions[0]!.length / 3);
    }
    const gone = new AbortController();
    const ended = matched([pear(), plum()], {}, { signal: gone.signal, onProgress: () => gone.abort() });
    await expect(ended).rejects.toMatchObject({ code: 'cancelled' });
  });
});

describe('what cannot be matched', () => {
  test.each<[string, string, (shape: Ball) => Float64Array]>([
    [
      'as many markers on one side as on the other are missing',
      'marker-count',
      (shape) => pointsOf(shape, shape.ends.slice(0, shape.faceOffsets.length > 800 ? 4 : 6)),
    ],
    ['a marker is nowhere', 'non-finite-marker', () => new Float64Array(9).fill(Number.NaN)],
    ['markers are not in threes', 'wrong-size', () => new Float64Array(10)],
  ])('%s', async (_, code, marked) => {
    await expect(matched([pear(), plum()], {}, {}, marked)).rejects.toMatchObject({ code, fault: 'input' });
  });

  test('one model alone', async () => {
    await expect(matched([pear()])).rejects.toMatchObject({ fault: 'input' });
  });
});

describe('sharp edges', () => {
  /** A drum of 24 sides. */
  const drum = () => {
    const positions: number[] = [];
    const faces: number[][] = [];
    for (let i = 0; i < 24; i++) {
      const turn = (i * Math.PI) / 12;
      positions.push(Math.cos(turn), 0, Math.sin(turn), Math.cos(turn), 1, Math.sin(turn));
      faces.push([2 * i, 2 * i + 1, (2 * i + 3) % 48, (2 * i + 2) % 48]);
    }
    faces.push(Array.from({ length: 24 }, (_, i) => 2 * i));
    faces.push(Array.from({ length: 24 }, (_, i) => 47 - 2 * i));
    return {
      positions: Float64Array.from(positions),
      faceOffsets: Uint32Array.from(
        [0, ...faces].map((_, i) => 4 * Math.min(i, 24) + 24 * Math.max(0, i - 24)),
      ),
      faceVertices: Uint32Array.from(faces.flat()),
    };
  };

  test('are the rims of a drum by a large angle, with its sides by a small one', async () => {
    const { id: model } = await kernel.call('openModel', drum());
    const rims = await kernel.call('sharpEdges', { model, angle: 40 });
    expect(rims.map((row) => [row.length, row[0] === row.at(-1)])).toEqual([
      [25, true],
      [25, true],
    ]);
    expect(new Set(rims[0]!.map((v) => v % 2)).size).toBe(1);
    expect((await kernel.call('sharpEdges', { model, angle: 10 })).length).toBeGreaterThan(24);
    expect(await kernel.call('sharpEdges', { model, angle: 120 })).toEqual([]);
    await kernel.call('release', { id: model });
  });
});

describe('places', () => {
  test('of one skin lie at the same weights on another', async () => {
    const { triangles, positions } = await matched([pear(), plum()]);
    const [from, to] = positions as [Float64Array, Float64Array];
    const [a, b, c] = triangles.subarray(30, 33);
    const middle = (skin: Float64Array) =>
      Float64Array.from(
        [0, 1, 2].map((axis) => [a!, b!, c!].reduce((sum, v) => sum + skin[3 * v + axis]! / 3, 0)),
      );
    const carried = await kernel.call('carryPlaces', { from, to, triangles, places: middle(from) });
    for (const [axis, x] of middle(to).entries()) expect(carried[axis]).toBeCloseTo(x, 9);
  });

  test('are guessed near where they belong once three are marked', async () => {
    const [source, target] = [pear(), plum()];
    const [from, to] = [await opened(source), await opened(target)];
    const guess = await kernel.call('guessPlace', {
      from,
      to,
      fromMarkers: pointsOf(source, source.ends.slice(0, 5)),
      toMarkers: pointsOf(target, target.ends.slice(0, 5)),
      place: pointsOf(source, [source.ends[5]!]),
    });
    const wanted = pointsOf(target, [target.ends[5]!]);
    expect(Math.hypot(...guess.map((x, axis) => x - wanted[axis]!))).toBeLessThan(0.25);
    for (const id of [from, to]) await kernel.call('release', { id });
  });
});
