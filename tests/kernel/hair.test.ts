import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, test } from 'vitest';
import type { KernelModule } from '../../wasm/bindings/kernel';
import type { KernelId, KernelPort } from '../../web/kernel/contract';
import type { HairOptions, HairStyle } from '../../web/kernel/contract/hair';
import { instantiate } from '../../web/kernel/module';
import { loadKernel } from '../../web/kernel/node';
import { combedDown, depth, egg, scalpOf, skin, style } from './hair-shapes';

let kernel: KernelPort;
beforeAll(async () => {
  kernel = await loadKernel();
});

const NO_STYLE: HairStyle = { streams: [], partings: [], ponytails: [] };

async function head(resolution = 20): Promise<KernelId> {
  const shape = egg();
  const { id: model } = await kernel.call('openModel', shape);
  const { id: hair } = await kernel.call('openHair', { model, scalp: scalpOf(shape), resolution, up: 'y' });
  return hair;
}

const grow = (hair: KernelId, count: number, options: HairOptions = {}, from = 0) =>
  kernel.call('growHair', { hair, from, count, options });

test('a head is prepared once and described', async () => {
  const shape = egg();
  const { id: model } = await kernel.call('openModel', shape);
  const seen: number[] = [];
  const opened = await kernel.call(
    'openHair',
    { model, scalp: scalpOf(shape), resolution: 32, up: 'y' },
    { onProgress: (fraction) => seen.push(fraction) },
  );
  expect(Math.max(...opened.grid)).toBe(32);
  expect(opened.headHeight).toBeCloseTo(0.24, 6);
  expect(opened.low[1]).toBeLessThan(-0.2);
  expect(opened.high[1]).toBeGreaterThan(0.12);
  expect(opened.seconds.prepare).toBeGreaterThan(0);
  for (const fraction of seen) expect(fraction).toBeLessThanOrEqual(1);
});

test('strokes become strands that stay out of the head, each with its root and clump', async () => {
  const hair = await head();
  const styled = await kernel.call('styleHair', { hair, style: style(combedDown()) });
  expect(styled.constraints).toBeGreaterThan(200);
  expect(styled.warnings).toEqual([]);
  const grown = await grow(hair, 2000, { curl: 0.5 });
  expect(grown.offsets).toHaveLength(2001);
  expect(grown.points).toHaveLength(3 * grown.offsets[2000]!);
  expect(grown.rootUvs).toHaveLength(4000);
  expect(grown.groups).toHaveLength(2000);
  expect(grown).toMatchObject({ insideHead: 0, reached: [], gathered: [] });
  expect(grown.shortStrands).toBeLessThan(10);
  const [x, y, z] = grown.origin as unknown as [number, number, number];
  let deepest = 2;
  for (let i = 0; i < grown.points.length; i += 3)
    deepest = Math.min(
      deepest,
      depth(grown.points[i]! + x, grown.points[i + 1]! + y, grown.points[i + 2]! + z),
    );
  expect(deepest).toBeGreaterThan(0.98);
  expect(Math.min(...grown.rootUvs)).toBeGreaterThanOrEqual(0);
  expect(Math.max(...grown.rootUvs)).toBeLessThanOrEqual(1);
});

test('a preview is a prefix of the whole, and a range the same strands', async () => {
  const hair = await head();
  await kernel.call('styleHair', { hair, style: style(combedDown()) });
  const [all, some, rest] = [await grow(hair, 300), await grow(hair, 100), await grow(hair, 200, {}, 100)];
  expect(some.points).toEqual(all.points.slice(0, some.points.length));
  expect(rest.points).toEqual(all.points.slice(some.points.length));
});

test('the same request gives the same bytes in another kernel', async () => {
  const bytes = async (port: KernelPort) => {
    const shape = egg();
    const { id: model } = await port.call('openModel', shape);
    const { id: hair } = await port.call('openHair', {
      model,
      scalp: scalpOf(shape),
      resolution: 20,
      up: 'y',
    });
    await port.call('styleHair', { hair, style: style(combedDown()) });
    return (await port.call('growHair', { hair, from: 0, count: 200, options: { curl: 1 } })).points;
  };
  expect(await bytes(await loadKernel())).toEqual(await bytes(kernel));
});

test('a painted length shortens the strands that root there', async () => {
  const hair = await head();
  await kernel.call('styleHair', { hair, style: style(combedDown()) });
  const options = { length: 0.1, lengthVariation: 0, frizz: 0, flyaways: 0, clump: 0 };
  const whole = await grow(hair, 100, options);
  const half = await grow(hair, 100, {
    ...options,
    lengthMap: new Float32Array(egg().positions.length / 3).fill(0.5),
  });
  expect(half.points.length / whole.points.length).toBeCloseTo(0.5, 0);
  expect(half.points.length).toBeLessThan(0.7 * whole.points.length);
});

test('the field can be shown: unit-sized arrows near the strokes', async () => {
  const hair = await head();
  await kernel.call('styleHair', { hair, style: style(combedDown()) });
  const { places, vectors } = await kernel.call('hairField', { hair, stride: 2 });
  expect(places).toHaveLength(vectors.length);
  expect(places.length).toBeGreaterThan(600);
  expect(vectors.every(Number.isFinite)).toBe(true);
});

test('what the field was asked for can be shown, and the field goes nearly that way there', async () => {
  const hair = await head();
  const { constraints } = await kernel.call('styleHair', { hair, style: style(combedDown()) });
  const asked = await kernel.call('hairConstraints', { hair });
  expect(asked.places).toHaveLength(3 * constraints);
  expect(asked.vectors).toHaveLength(3 * constraints);
  const field = await kernel.call('hairField', { hair, stride: 1 });
  const at = new Map<string, number>();
  for (let i = 0; i < field.places.length; i += 3) at.set(field.places.subarray(i, i + 3).join(), i);
  let worst = 0;
  for (let i = 0; i < asked.places.length; i += 3) {
    const node = at.get(asked.places.subarray(i, i + 3).join())!;
    const along = [0, 1, 2].map((k) => asked.vectors[i + k]!);
    const off = [0, 1, 2].map((k) => field.vectors[node + k]! - along[k]!);
    worst = Math.max(worst, Math.hypot(...off) / Math.hypot(...along));
  }
  expect(worst).toBeLessThan(0.05);

  await kernel.call('styleHair', { hair, style: NO_STYLE });
  expect((await kernel.call('hairConstraints', { hair })).places).toHaveLength(0);
});

test('growing reports progress and stops when asked; a style change meanwhile does no harm', async () => {
  const hair = await head();
  await kernel.call('styleHair', { hair, style: style(combedDown()) });
  const abort = new AbortController();
  const call = kernel.call(
    'growHair',
    { hair, from: 0, count: 200_000, options: {} },
    { signal: abort.signal, onProgress: () => abort.abort() },
  );
  await expect(call).rejects.toMatchObject({ code: 'cancelled' });

  const seen: number[] = [];
  const growing = kernel.call(
    'growHair',
    { hair, from: 0, count: 20_000, options: {} },
    { onProgress: (fraction) => seen.push(fraction) },
  );
  await kernel.call('styleHair', { hair, style: NO_STYLE });
  expect((await growing).offsets).toHaveLength(20_001);
  expect([...seen].sort((a, b) => a - b)).toEqual(seen);
});

describe('what cannot be is said, what is odd is told', () => {
  test.each<[code: string, change: { scalp?: number[]; resolution?: number }]>([
    ['scalp-empty', { scalp: [] }],
    ['scalp-empty', { scalp: [0, 1] }],
    ['scalp-vertex', { scalp: [123_456] }],
    ['bad-resolution', { resolution: 8 }],
    ['bad-resolution', { resolution: 500 }],
  ])('%s', async (code, { scalp, resolution = 20 }) => {
    const shape = egg();
    const { id: model } = await kernel.call('openModel', shape);
    const vertices = scalp ? Uint32Array.from(scalp) : scalpOf(shape);
    const call = kernel.call('openHair', { model, scalp: vertices, resolution, up: 'y' });
    await expect(call).rejects.toMatchObject({ code, fault: 'input' });
  });

  test('ten million strands are refused in a sentence, and none are an answer', async () => {
    const hair = await head(16);
    await expect(grow(hair, 10_000_000)).rejects.toMatchObject({
      code: 'too-many-strands',
      message: expect.stringMatching(/1,000,000 strands/),
    });
    await expect(grow(hair, 10, { clump: 3 })).rejects.toMatchObject({ code: 'bad-option' });
    await kernel.call('styleHair', { hair, style: style(combedDown()) });
    expect((await grow(hair, 0)).offsets).toEqual(Uint32Array.of(0));
  });

  test('a head without a style grows nothing and says why', async () => {
    const hair = await head(16);
    const { warnings } = await kernel.call('styleHair', { hair, style: NO_STYLE });
    expect(warnings.map(({ code }) => code)).toEqual(['style-empty']);
    expect((await grow(hair, 100)).offsets).toHaveLength(1);
  });

  test('a stroke of one point, one off the head, and a ponytail inside it are passed over', async () => {
    const hair = await head(16);
    const lines = [...combedDown(), [skin([0, 1, 0])], [skin([0, 1, 0], 9), skin([1, 1, 0], 9)]];
    const ring = Array.from({ length: 12 }, (_, i) => [0.01 * Math.cos(i / 2), 0.01 * Math.sin(i / 2), 0.01]);
    const tail = {
      spine: Float64Array.of(0, 0, 0, 0, 0, 0.03),
      section: Float64Array.from(ring.flat()),
      profiles: [],
      tightness: 0.6,
    };
    const { warnings } = await kernel.call('styleHair', {
      hair,
      style: { ...style(lines), ponytails: [tail] },
    });
    expect(warnings.map(({ code, examples }) => [code, ...examples])).toEqual([
      ['stroke-too-short', 8],
      ['stroke-outside', 9],
      ['ponytail-inside-head', 10],
    ]);
    expect((await grow(hair, 200)).insideHead).toBe(0);
  });

  test('a released head is a void id', async () => {
    const hair = await head(16);
    await kernel.call('release', { id: hair });
    await expect(grow(hair, 1)).rejects.toMatchObject({ code: 'worker-restarted' });
    expect(kernel.epoch).toBe(0);
  });
});

test('hair gives its memory back, and the module has what its declaration says', async () => {
  const bytes = readFileSync(new URL('../../wasm/dist/kernel.wasm', import.meta.url));
  const wasm: KernelModule = await instantiate(await WebAssembly.compile(new Uint8Array(bytes)));
  const shape = egg();
  const round = () => {
    const model = new wasm.WorkingMesh(shape.positions, shape.faceOffsets, shape.faceVertices);
    const hair = new wasm.HairSession(model, scalpOf(shape), 16, 'y');
    while (hair.step());
    hair.style(style(combedDown()));
    const growth = new wasm.HairGrowth(hair, 0, 500, {});
    while (growth.step());
    growth.take();
    growth.delete();
    hair.delete();
    model.delete();
  };
  for (let i = 0; i < 3; i++) round();
  const live = wasm.liveBytes();
  for (let i = 0; i < 10; i++) round();
  expect(wasm.liveBytes() - live).toBeLessThan(4096);

  const declared = readFileSync(new URL('../../wasm/bindings/hair.d.ts', import.meta.url), 'utf8');
  for (const name of ['HairSession', 'HairGrowth'] as const) {
    const body = declared.match(new RegExp(`interface Wasm${name}[^{]*\\{(.*?)\\n\\}`, 's'))?.[1] ?? '';
    const members = [...body.matchAll(/^ {2}(\w+)\(/gm)].map((match) => match[1]);
    expect(members.length).toBeGreaterThan(0);
    for (const member of members)
      expect((wasm[name] as unknown as { prototype: object }).prototype).toHaveProperty(member as string);
  }
});
