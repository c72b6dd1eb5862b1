// The curves workspace on the real kernel, with a view that looks along −z at a hundred pixels to the unit.

import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { afterEach, beforeAll, beforeEach, describe, expect, test, vi } from 'vitest';
import { pictureKey } from '../../web/app/curves/pose-pictures';
import { readModel, writeModel } from '../../web/io/index';
import type { KernelPort } from '../../web/kernel/contract';
import { loadKernel } from '../../web/kernel/node';
import { itemOf } from '../../web/tools/curves/items';
import { pickLine } from '../../web/view/overlays/control-lines';
import type { ControlLine } from '../../web/view/overlays/types';
import type { PointerHandler, PointerSample, RegionPaint, Vec3 } from '../../web/view/types';
import { dome, tube } from '../kernel/tubes';
import { Browser, blindViewport, file, MemoryStorage, Tab } from './world';

let kernel: KernelPort;
beforeAll(async () => {
  kernel = await loadKernel();
});
beforeEach(() => vi.stubGlobal('fetch', async () => new Response('', { status: 404 })));
afterEach(() => vi.unstubAllGlobals());

/** From y = 0 to 2, 0.6 wide; its top is closed. */
const LIMB = writeModel(
  { name: 'limb', ...tube(48, 24, (s, t) => dome(s, t).map((x, k) => (k === 1 ? x : 0.3 * x)) as never) },
  'obj',
);
const SCALE = 100;
const onScreen = ([x, y]: readonly [number, number, ...number[]]) => ({
  x: 400 + SCALE * x,
  y: 300 - SCALE * y,
});

class Bench {
  readonly pictures: Float64Array[] = [];
  lines: readonly ControlLine[] = [];
  regions: readonly RegionPaint[] = [];
  handler: PointerHandler | null = null;
  readonly tab: Tab;

  constructor() {
    const view = blindViewport(
      {
        camera: { position: [0, 1, 5], target: [0, 1, 0], orthographic: true },
        pointOnScreenPlane: (x, y, [, , z]) => [(x - 400) / SCALE, (300 - y) / SCALE, z],
        project: (point) => ({ ...onScreen(point), behind: false }),
        pixelSize: () => 1 / SCALE,
        setRegions: (regions) => {
          this.regions = regions;
        },
        setPointerHandler: (handler) => {
          this.handler = handler;
        },
        thumbnail: async (positions) => {
          this.pictures.push(positions);
          return new Blob(['a picture']);
        },
      },
      {
        'inner-lines': {
          setLines: (lines: readonly ControlLine[]) => {
            this.lines = lines;
          },
          pickLine: (x: number, y: number) =>
            pickLine(this.lines, x, y, (point) => ({ ...onScreen(point), z: 1 })),
        },
      },
    );
    this.tab = new Tab(new Browser(), new MemoryStorage(), view, false, kernel);
  }

  static async open(model: Uint8Array | string = LIMB): Promise<Bench> {
    const bench = new Bench();
    const { app } = bench.tab;
    await app.files.openFiles([file('limb.obj', model)]);
    await app.evaluator.settled();
    await app.commands.run('workspace.curves');
    await bench.settled();
    return bench;
  }

  /** With a curve of five points up the limb. */
  static async drawn(): Promise<Bench> {
    const bench = await Bench.open();
    await bench.tool('sketch-curve');
    await bench.stroke([0, 0.15], [0, 1.8]);
    await vi.waitFor(() => expect(bench.step.curves).toHaveLength(1));
    await bench.tool('pose-curves');
    await bench.settled();
    return bench;
  }

  get step() {
    return this.tab.curvesState.step.value!;
  }

  get rest(): readonly Vec3[] {
    return this.step.curves[0]!.rest;
  }

  get positions(): Float64Array {
    return this.tab.app.evaluator.result.value!.positions;
  }

  async tool(id: string): Promise<void> {
    await this.tab.app.commands.run(`tool.${id}`);
  }

  /** What follows the result has been read as well. */
  async settled(): Promise<void> {
    await this.tab.app.evaluator.settled();
    await new Promise((resolve) => setTimeout(resolve, 20));
  }

  at([x, y]: readonly [number, number], more: Partial<PointerSample> = {}): PointerSample {
    const hit = Math.abs(x) < 0.25 && y > 0.05 && y < 1.9 ? { point: [x, y, 0.25], vertex: 0 } : null;
    return {
      ...onScreen([x, y]),
      pressure: 0.5,
      pointerType: 'mouse',
      button: 0,
      shift: false,
      alt: false,
      ctrl: false,
      hit: hit as PointerSample['hit'],
      ...more,
    };
  }

  /** Pressed, moved and let go. @returns whether a tool took it */
  async stroke(from: readonly [number, number], to: readonly [number, number], look?: () => void) {
    const taken = this.handler!.down(this.at(from));
    if (!taken) return false;
    for (let k = 1; k <= 20; k++) {
      const place = [0, 1].map((i) => from[i]! + ((to[i]! - from[i]!) * k) / 20);
      this.handler!.move([this.at(place as [number, number])]);
      if (k % 5 === 0) await new Promise((resolve) => setTimeout(resolve, 5));
    }
    if (look) await vi.waitFor(look);
    this.handler!.up(this.at(to));
    await this.settled();
    return true;
  }
}

describe('drawing', () => {
  test('a stroke under way shows its curve and what would follow it, and becomes a curve', async () => {
    const bench = await Bench.open();
    const { curvesState } = bench.tab;
    await bench.tool('sketch-curve');
    const rest = bench.positions;
    await bench.stroke([0, 0.15], [0, 1.8], () => {
      expect(bench.lines.map(({ id }) => id)).toEqual(['stroke', 'foreseen']);
      expect(bench.regions.map(({ id }) => id)).toEqual(['region']);
      expect(bench.regions[0]!.vertices.length).toBeGreaterThan(500);
    });
    await vi.waitFor(() => expect(bench.step.curves).toHaveLength(1));
    expect(curvesState.foreseen.value).toBeNull();
    expect(curvesState.reached.value).toBeNull();
    // In the middle of the limb, not on the side that was seen.
    for (const [x, , z] of bench.rest) expect(Math.hypot(x, z)).toBeLessThan(0.03);
    await bench.settled();
    expect(bench.positions.every((p, i) => Math.abs(p - rest[i]!) < 1e-12)).toBe(true);
    await bench.tab.app.commands.run('edit.undo');
    expect(bench.step.curves).toEqual([]);
  });

  test('beside the model the camera turns; a point is no stroke', async () => {
    const bench = await Bench.open();
    await bench.tool('sketch-curve');
    expect(await bench.stroke([1, 1], [1, 1.5])).toBe(false);
    bench.handler!.down(bench.at([0, 1]));
    bench.handler!.up(bench.at([0, 1]));
    expect(bench.tab.toasts.at(-1)).toBe('The stroke is too short. Draw along the limb.');
    expect(bench.step.curves).toEqual([]);
  });

  test('points without faces are drawn on like a surface, and leave as points', async () => {
    const lines = new TextDecoder().decode(LIMB).split('\n');
    const bench = await Bench.open(lines.filter((line) => line.startsWith('v ')).join('\n'));
    await bench.tool('sketch-curve');
    await bench.stroke([0, 0.15], [0, 1.8]);
    await vi.waitFor(() => expect(bench.step.curves).toHaveLength(1));
    for (const [x, , z] of bench.rest) expect(Math.hypot(x, z)).toBeLessThan(0.05);
    await bench.tab.app.files.exportModel('ply');
    const { model } = readModel(bench.tab.saved.at(-1)!.bytes, 'limb.ply');
    expect(model.positions).toHaveLength(bench.positions.length);
    expect(model.faceVertices).toHaveLength(0);
  });

  test('with the mirror one stroke beside the plane makes two curves', async () => {
    const bench = await Bench.open();
    bench.tab.app.state.mirror.value = true;
    bench.tab.curvesState.kind.value = 'surface';
    await bench.tool('sketch-curve');
    await bench.stroke([0.15, 0.3], [0.15, 1.5]);
    await vi.waitFor(() => expect(bench.step.curves).toHaveLength(2));
    const [a, b] = bench.step.curves;
    expect(b!.rest.map(([x, y, z]) => [-x, y, z])).toEqual(a!.rest.map((point) => [...point]));
  });
});

describe('posing', () => {
  test('what is under the pointer lights up; a dragged point bends, the far end stays', async () => {
    const bench = await Bench.drawn();
    const [x, y] = bench.rest.at(-1)!;
    bench.handler!.hover(bench.at([x, y]));
    expect(bench.lines[0]!.under).toBe(bench.rest.length - 1);
    bench.handler!.hover(bench.at([x, (y + bench.rest.at(-2)![1]) / 2]));
    expect(bench.lines[0]!.under).toBe('line');
    bench.handler!.leave();
    expect(bench.lines[0]!.under).toBeUndefined();

    const before = bench.positions;
    await bench.stroke([x, y], [x + 0.5, y - 0.2]);
    const moved = (row: number) =>
      Math.hypot(...[0, 1, 2].map((k) => bench.positions[3 * row + k]! - before[3 * row + k]!));
    expect(moved(0)).toBeLessThan(1e-9);
    expect(moved(46 * 24)).toBeGreaterThan(0.4);
    expect(bench.step.curves[0]!.posed!.at(-1)![0]).toBeCloseTo(x + 0.5, 3);
  });

  test('Escape gives a drag back', async () => {
    const bench = await Bench.drawn();
    const { document } = bench.tab.app;
    const before = document.recipe;
    const [x, y] = bench.rest.at(-1)!;
    bench.handler!.down(bench.at([x, y]));
    bench.handler!.move([bench.at([x + 0.4, y])]);
    await bench.settled();
    expect(bench.step.curves[0]!.posed).toBeDefined();
    bench.handler!.cancel();
    await bench.settled();
    expect(document.recipe).toBe(before);
    expect(bench.step.curves[0]!.posed).toBeUndefined();
  });

  test('an end slides along its curve to trim, straight on to extend', async () => {
    const bench = await Bench.drawn();
    await bench.tab.app.commands.run('curves.gizmo.end');
    const [x, y] = bench.rest.at(-1)!;
    const middle = bench.rest[2]!;
    // Only ends can be taken hold of.
    expect(await bench.stroke([middle[0], middle[1]], [0.3, 1])).toBe(false);
    bench.handler!.hover(bench.at([middle[0], middle[1]]));
    expect(bench.lines[0]!.under).toBeUndefined();

    await bench.stroke([x, y], [x + 0.03, 1.2]);
    expect(bench.rest.at(-1)![1]).toBeCloseTo(1.2, 1);
    expect(bench.rest[0]![1]).toBeCloseTo(0.15, 1);
    const [x2, y2] = bench.rest.at(-1)!;
    await bench.stroke([x2, y2], [x2, 1.6]);
    expect(bench.rest.at(-1)![1]).toBeCloseTo(1.6, 1);
    await bench.tab.app.commands.run('edit.undo');
    await bench.tab.app.commands.run('edit.undo');
    expect(bench.rest.at(-1)![1]).toBe(y);
  });

  test('numbers typed are one step of undo, however many are tried on the way', async () => {
    const bench = await Bench.drawn();
    const { curves, app } = bench.tab;
    const grip = { curve: 0, point: bench.rest.length - 1 };
    app.document.select(itemOf(grip));
    const before = app.document.recipe;
    for (const degrees of [10, 40, 90]) curves.setTwist(grip, degrees);
    curves.edits.finish();
    await bench.settled();
    expect(bench.step.curves[0]!.twist!.at(-1)).toBe(90);
    await app.commands.run('edit.undo');
    expect(app.document.recipe).toEqual(before);
  });
});

describe('poses', () => {
  async function twoPoses(): Promise<Bench> {
    const bench = await Bench.drawn();
    const { curves } = bench.tab;
    curves.addPose();
    const grip = { curve: 0, point: bench.rest.length - 1 };
    const [x, y, z] = bench.rest.at(-1)!;
    curves.setPoint(grip, [x + 0.6, y - 0.3, z]);
    curves.edits.finish();
    await bench.settled();
    curves.addPose();
    await bench.settled();
    return bench;
  }

  test('each has a picture of the model as it stands in it; what goes takes it along', async () => {
    const bench = await twoPoses();
    const { curves } = bench.tab;
    await vi.waitFor(() => expect(bench.step.poses.every((pose) => curves.picture(pose))).toBe(true));
    expect(bench.pictures).toHaveLength(2);
    const shown = bench.positions;
    const [first, second] = bench.pictures;
    expect(second!.every((p, i) => Math.abs(p - shown[i]!) < 1e-12)).toBe(true);
    expect(first!.some((p, i) => Math.abs(p - shown[i]!) > 0.3)).toBe(true);

    curves.removePose(0);
    await bench.settled();
    await vi.waitFor(() => expect(bench.tab.curvesState.posePictures.value.size).toBe(1));
    // A pose that is only renamed keeps its picture.
    curves.renamePose(0, 'bowed');
    await bench.settled();
    expect(curves.picture(bench.step.poses[0]!)).toBeDefined();
    expect(bench.pictures).toHaveLength(2);
  });

  test('whatever changes what is seen asks for another picture', async () => {
    const bench = await twoPoses();
    const { step } = bench;
    const [pose] = step.poses;
    const [curve] = step.curves;
    const key = pictureKey(step, pose!);
    for (const change of [
      { region: { ranges: [[0, 40]] } },
      { reach: 0.2 },
      { rigid: [0] },
      { anchor: 'end' },
    ])
      expect(pictureKey({ ...step, curves: [{ ...curve!, ...(change as object) }] }, pose!)).not.toBe(key);
    // The posture of the moment is none of it.
    expect(pictureKey({ ...step, curves: [{ ...curve!, twist: [1, 2, 3, 4, 5] }] }, pose!)).toBe(key);
  });

  test('they are taken up, blended in one step of undo, and removed', async () => {
    const bench = await twoPoses();
    const { curves, app } = bench.tab;
    const bowed = bench.positions;
    curves.takePose(0);
    await bench.settled();
    expect(bench.step.curves[0]!.posed).toBeUndefined();
    curves.blend(0, 1, 0.5);
    curves.blend(0, 1, 1);
    curves.edits.finish();
    await bench.settled();
    expect(bench.positions.every((p, i) => Math.abs(p - bowed[i]!) < 1e-9)).toBe(true);
    await app.commands.run('edit.undo');
    expect(bench.step.curves[0]!.posed).toBeUndefined();
  });

  test('they play without changing the document, until Escape', async () => {
    const frames: FrameRequestCallback[] = [];
    vi.stubGlobal('requestAnimationFrame', (frame: FrameRequestCallback) => frames.push(frame));
    vi.stubGlobal('cancelAnimationFrame', () => {});
    const bench = await twoPoses();
    const { app, curvesState } = bench.tab;
    const { recipe } = app.document;
    await app.commands.run('curves.play');
    expect(curvesState.playing.value).toBe(true);
    const xs: number[] = [];
    for (const time of [0, 200, 400, 600]) {
      frames.at(-1)!(time);
      await app.evaluator.settled();
      const { posed, rest } = bench.step.curves[0]!;
      xs.push((posed ?? rest).at(-1)![0]);
    }
    // It goes one way from the first pose to the second.
    expect(xs).toEqual([...xs].sort((a, b) => a - b));
    expect(xs.at(-1)! - xs[0]!).toBeGreaterThan(0.3);
    expect(app.document.recipe).toBe(recipe);
    await app.commands.run('edit.cancel');
    await bench.settled();
    expect(curvesState.playing.value).toBe(false);
    expect(app.document.recipe).toBe(recipe);
  });
});

describe('export', () => {
  test('a skeleton with the poses as an animation, opened by the loader of three.js', async () => {
    const bench = await Bench.drawn();
    const { curves, app, saved } = bench.tab;
    curves.addPose();
    curves.setPoint({ curve: 0, point: 2 }, [0.3, 1, 0]);
    curves.edits.finish();
    curves.addPose();
    const group = app.files.exportGroup()!;
    expect(group.choices.map(({ format }) => format)).toEqual(['glb']);
    await app.files.exportOf(group, 'glb', false);
    const { name, bytes } = saved.at(-1)!;
    expect(name).toBe('limb.glb');
    const { scene, animations } = await new GLTFLoader().parseAsync(bytes.slice().buffer, '');
    expect(animations).toHaveLength(1);
    let bones = 0;
    scene.traverse((object) => {
      if ((object as { isBone?: boolean }).isBone) bones++;
    });
    expect(bones).toBeGreaterThan(30);
  });

  test('without a curve it says so', async () => {
    const { tab } = await Bench.open();
    const group = tab.app.files.exportGroup()!;
    await expect(tab.app.files.exportOf(group, 'glb', false)).rejects.toThrow('There is no curve yet');
  });
});
