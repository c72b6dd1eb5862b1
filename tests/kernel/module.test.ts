import { readdirSync, readFileSync } from 'node:fs';
import { beforeAll, describe, expect, test } from 'vitest';
import type { KernelModule } from '../../wasm/bindings/kernel';
import type { KernelId, KernelPort } from '../../web/kernel/contract';
import type { DeformOptions } from '../../web/kernel/contract/deform';
import { instantiate } from '../../web/kernel/module';
import { loadKernel } from '../../web/kernel/node';
import { affine, allVertices, bar, gap, type Shape, sheet, transformed, verticesWhere } from './shapes';

const bindings = new URL('../../wasm/bindings/', import.meta.url);

let kernel: KernelPort;
beforeAll(async () => {
  kernel = await loadKernel();
});

const identity = affine(
  [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  [0, 0, 0],
);
const sheared = affine(
  [
    [1.2, 0.3, 0],
    [-0.1, 0.9, 0.2],
    [0.1, 0, 1.1],
  ],
  [3, -2, 1],
);
const turnedAndGrown = affine(
  [
    [0.9, -1.2, 0],
    [1.2, 0.9, 0],
    [0, 0, 1.5],
  ],
  [-4, 5, 2],
);
const shapes: [name: string, shape: Shape][] = [
  ['a closed bar with flat sides', bar(12, 3)],
  ['an open sheet', sheet(12, 7)],
];

/** Everything may move; the two ends are handles. */
async function prepare(shape: Shape, options: DeformOptions = {}) {
  const { id: model } = await kernel.call('openModel', shape);
  const handles = [
    { kind: 'region', vertices: verticesWhere(shape, (x) => x < 1.5) },
    { kind: 'region', vertices: verticesWhere(shape, (x) => x > 10.5) },
  ] as const;
  const prepared = await kernel.call('prepareDeform', { model, roi: allVertices(shape), handles, options });
  return { model, deform: prepared.id, ...prepared };
}

async function moved(shape: Shape, options: DeformOptions, targets: number[]): Promise<Float64Array> {
  const { model, deform } = await prepare(shape, options);
  const { positions } = await kernel.call('deform', { deform, targets: Float64Array.from(targets) });
  await kernel.call('release', { id: deform });
  await kernel.call('release', { id: model });
  return positions;
}

describe.each(shapes)('%s', (_, shape) => {
  test('follows a common affine map of its handles exactly when shear is kept', async () => {
    const positions = await moved(shape, { removeShear: false }, [...sheared, ...sheared]);
    expect(gap(positions, transformed(shape.positions, sheared))).toBeLessThan(1e-6);
  });

  test('follows a common similarity exactly when shear is removed and details scale', async () => {
    const options = { removeShear: true, scaleDetails: true };
    const positions = await moved(shape, options, [...turnedAndGrown, ...turnedAndGrown]);
    expect(gap(positions, transformed(shape.positions, turnedAndGrown))).toBeLessThan(1e-6);
  });

  test('comes back unchanged when its handles rest', async () => {
    for (const method of ['implicit', 'iterative', 'naive'] as const) {
      const positions = await moved(shape, { method, iterations: method === 'iterative' ? 3 : 1 }, [
        ...identity,
        ...identity,
      ]);
      expect(gap(positions, shape.positions)).toBeLessThan(1e-6);
    }
  });
});

test('a model is described in the terms of its own file', async () => {
  const shape = sheet(4, 3);
  const opened = await kernel.call('openModel', shape);
  expect(opened).toMatchObject({
    components: 1,
    boundaryLoops: 1,
    eulerCharacteristic: 1,
    closed: false,
    oriented: true,
  });
  expect(opened.triangles).toHaveLength(3 * 2 * 12);
  expect([...opened.faceOfTriangle]).toEqual(Array.from({ length: 24 }, (_, t) => Math.floor(t / 2)));
  expect(opened.welded).toHaveLength(20);
  expect(opened.findings.map(({ code }) => code)).toContain('open-boundary');
});

test('measures are neutral at rest and see a stretch', async () => {
  const shape = bar(12, 3);
  const { id: model } = await kernel.call('openModel', shape);
  const rest = await kernel.call('measure', { model, positions: shape.positions });
  expect(rest).toMatchObject({ worstStretch: 1, edgeRms: 0, flippedTriangles: 0 });
  expect(rest.volumeRatio).toBeCloseTo(1, 12);
  const doubled = await kernel.call('measure', { model, positions: shape.positions.map((x) => 2 * x) });
  expect(doubled.volumeRatio).toBeCloseTo(8, 9);
  expect(doubled.stretch).toBeInstanceOf(Float32Array);
  expect(Math.min(...doubled.stretch)).toBeCloseTo(1, 5);
});

test('a session outlives its model, and releasing twice or anything at all is harmless', async () => {
  const { model, deform } = await prepare(bar(12, 3));
  for (const id of [model, model, 12_345 as KernelId]) await kernel.call('release', { id });
  const targets = Float64Array.from([...identity, ...identity]);
  const { positions } = await kernel.call('deform', { deform, targets });
  expect(gap(positions, bar(12, 3).positions)).toBeLessThan(1e-6);
  for (const id of [deform, deform]) await kernel.call('release', { id });
  await expect(kernel.call('deform', { deform, targets })).rejects.toMatchObject({
    code: 'worker-restarted',
  });
  expect(kernel.epoch).toBe(0);
});

describe('mistakes are named', () => {
  const shape = sheet(3, 3);
  const open = (change: Partial<Shape>) => kernel.call('openModel', { ...shape, ...change });

  test.each<[code: string, change: Partial<Shape>]>([
    ['no-vertices', { positions: new Float64Array() }],
    [
      'no-faces',
      { positions: new Float64Array(27), faceOffsets: Uint32Array.of(0), faceVertices: new Uint32Array() },
    ],
    ['no-usable-faces', { faceVertices: shape.faceVertices.map(() => 0) }],
    ['wrong-size', { positions: shape.positions.subarray(1) }],
    ['bad-face-offsets', { faceOffsets: Uint32Array.of(0, 8, 4) }],
    ['bad-face-offsets', { faceOffsets: Uint32Array.of(0, 4_000_000_000) }],
  ])('%s', async (code, change) => {
    await expect(open(change)).rejects.toMatchObject({ name: 'LissomError', code, fault: 'input' });
  });

  test.each<[code: string, handles: number[][], options: object]>([
    ['no-handle', [], {}],
    ['empty-handle', [[]], {}],
    ['vertex-out-of-range', [[99]], {}],
    [
      'handle-overlap',
      [
        [0, 1],
        [1, 2],
      ],
      {},
    ],
    ['bad-option', [[0, 1]], { method: 'magic' }],
    ['bad-option', [[0, 1]], { iterations: 0 }],
    ['bad-option', [[0, 1]], { coherenceRing: 3 }],
  ])('%s', async (code, groups, options) => {
    const { id: model } = await open({});
    const handles = groups.map((vertices) => ({
      kind: 'region' as const,
      vertices: Uint32Array.from(vertices),
    }));
    const call = kernel.call('prepareDeform', { model, roi: allVertices(shape), handles, options });
    await expect(call).rejects.toMatchObject({ code, fault: 'input' });
  });

  test.each<[code: string, targets: number[]]>([
    ['handle-count', [...identity]],
    ['handle-count', [...identity, 1]],
    ['non-finite-target', [...identity, ...identity.map((x, at) => (at === 12 ? Number.NaN : x))]],
    ['non-finite-target', [...identity, ...identity.map((x, at) => (at === 15 ? Number.NaN : x))]],
    ['not-affine', [...identity, ...identity.map((x, at) => (at === 15 ? 2 : x))]],
  ])('%s of a drag', async (code, targets) => {
    const { deform } = await prepare(bar(12, 3));
    const call = kernel.call('deform', { deform, targets: Float64Array.from(targets) });
    await expect(call).rejects.toMatchObject({ code, fault: 'input' });
  });

  test('none of them costs the kernel its state', () => expect(kernel.epoch).toBe(0));
});

test('preparing reports progress and stops when asked', async () => {
  const shape = sheet(160, 100);
  const { id: model } = await kernel.call('openModel', shape);
  const handles = [{ kind: 'region' as const, vertices: verticesWhere(shape, (x) => x < 1.5) }];
  const args = { model, roi: allVertices(shape), handles, options: { coherenceRing: 2 as const } };
  const abort = new AbortController();
  const seen: number[] = [];
  const onProgress = (fraction: number) => {
    seen.push(fraction);
    abort.abort();
  };
  const call = kernel.call('prepareDeform', args, { signal: abort.signal, onProgress });
  await expect(call).rejects.toMatchObject({ code: 'cancelled' });
  expect(seen).toHaveLength(1);
  expect(seen[0]).toBeGreaterThanOrEqual(0);
  expect(seen[0]).toBeLessThanOrEqual(1);
});

describe('the module itself', () => {
  let wasm: KernelModule;
  beforeAll(async () => {
    const bytes = readFileSync(new URL('../../wasm/dist/kernel.wasm', import.meta.url));
    wasm = await instantiate(await WebAssembly.compile(new Uint8Array(bytes)));
  });

  function round(shape: Shape): void {
    const model = new wasm.WorkingMesh(shape.positions, shape.faceOffsets, shape.faceVertices);
    const handles = [{ kind: 'region' as const, vertices: verticesWhere(shape, (x) => x < 1.5) }];
    const session = new wasm.DeformSession(model, allVertices(shape), handles, {});
    while (session.step());
    session.deform(Float64Array.from(identity), true);
    expect(() => session.deform(new Float64Array(1), true)).toThrow();
    wasm.measure(model, shape.positions);
    session.delete();
    model.delete();
  }

  test('memory is given back: many rounds cost what a few do', () => {
    const shape = bar(12, 3);
    for (let i = 0; i < 5; i++) round(shape);
    const [live, peak] = [wasm.liveBytes(), wasm.peakBytes()];
    for (let i = 0; i < 60; i++) round(shape);
    expect(wasm.liveBytes() - live).toBeLessThan(4096);
    expect(wasm.peakBytes() - peak).toBeLessThan(0.1 * peak);
  });

  test('exports what the declarations say and the bindings name, no more and no less', () => {
    const declared = readdirSync(bindings)
      .filter((name) => name.endsWith('.d.ts'))
      .map((name) => readFileSync(new URL(name, bindings), 'utf8'))
      .join('\n');
    const membersOf = (name: string): string[] =>
      [
        ...declared.matchAll(
          new RegExp(`interface ${name}(?!\\s+extends \\w+Module)[^{]*\\{(.*?)\\n\\}`, 'gs'),
        ),
      ]
        .flatMap(([, body = '']) => [...body.matchAll(/^ {2}(?:readonly )?(\w+)[(:]/gm)])
        .map((match) => match[1] as string)
        .sort();
    const bound = readdirSync(bindings)
      .filter((name) => name.endsWith('.cpp'))
      .flatMap((name) => {
        const source = readFileSync(new URL(name, bindings), 'utf8');
        return [...source.matchAll(/class_<[^>]+>\("(\w+)"\)|[^.]\bfunction\("(\w+)"/g)];
      })
      .map((match) => match[1] ?? match[2]);
    expect(membersOf('\\w+Module')).toEqual(bound.sort());
    for (const name of bound) expect(wasm).toHaveProperty(name as string, expect.any(Function));

    const everyObject = ['clone', 'delete', 'deleteLater', 'isAliasOf', 'isDeleted', 'constructor'];
    const methodsOf = (made: { prototype: object }) =>
      Object.getOwnPropertyNames(made.prototype)
        .filter((name) => !everyObject.includes(name))
        .sort();
    expect(methodsOf(wasm.WorkingMesh as never)).toEqual(membersOf('WasmWorkingMesh'));
    expect(methodsOf(wasm.DeformSession as never)).toEqual(membersOf('WasmDeformSession'));
  });
});

test('a model beyond the memory is refused in a sentence, and the kernel works on', async () => {
  const own = await loadKernel();
  const positions = new Float64Array(3 * 100_000_000); // never touched, so it costs this machine nothing
  await expect(own.call('openModel', { ...sheet(3, 3), positions })).rejects.toMatchObject({
    code: 'out-of-memory',
    fault: 'memory',
    message: expect.stringMatching(/not enough memory/),
  });
  expect(own.epoch).toBe(1);
  expect(await own.call('openModel', sheet(3, 3))).toMatchObject({ components: 1 });
});

test('ids of one kernel mean nothing to another', async () => {
  const other = await loadKernel();
  const call = other.call('deform', { deform: 99 as KernelId, targets: new Float64Array(16) });
  await expect(call).rejects.toMatchObject({ code: 'worker-restarted' });
});

test('a kernel that is not where it should be says how to build it', async () => {
  await expect(loadKernel('/nowhere/kernel.wasm')).rejects.toMatchObject({
    code: 'kernel-not-found',
    message: expect.stringContaining('npm run wasm'),
  });
});
