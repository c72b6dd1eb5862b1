import { Group } from 'three';
import { beforeEach, describe, expect, test } from 'vitest';
import type { Layer, LayerKind } from '../../web/view/layer';
import { Layers } from '../../web/view/layers';
import { ModelView } from '../../web/view/model-view';
import { PALETTES } from '../../web/view/palette';
import type { SurfaceShade } from '../../web/view/surface-shade';
import { ViewSpace } from '../../web/view/view-space';
import { contextOf } from './card';
import { identityWeld, sphere } from './shapes';

type Call = readonly [layer: string, method: string, ...args: unknown[]];

let calls: Call[];
let redraws: number;
let layers: Layers;

beforeEach(() => {
  calls = [];
  redraws = 0;
  layers = new Layers(contextOf({ redraw: () => redraws++ }));
});

/** A layer that writes down what it is told. */
function recorder(id: string, parts: Partial<Layer> = {}): LayerKind<{ settle(): void }> {
  const told =
    (method: string) =>
    (...args: unknown[]) =>
      void calls.push([id, method, ...args]);
  return {
    id,
    make: (context) => ({
      group: new Group(),
      place: told('place'),
      setPalette: told('setPalette'),
      resize: told('resize'),
      modelSettled: told('modelSettled'),
      restore: told('restore'),
      setKept: told('setKept'),
      paced: told('paced'),
      prepare: told('prepare'),
      dispose: told('dispose'),
      settle: () => context.settle(),
      ...parts,
    }),
  };
}

function model(): ModelView {
  const { positions, triangles } = sphere(2);
  const faceOffsets = Uint32Array.from({ length: triangles.length / 3 + 1 }, (_, i) => 3 * i);
  const welded = identityWeld(positions.length / 3);
  return new ModelView({
    positions: positions.map((x) => 3 * x),
    triangles,
    faceOffsets,
    faceVertices: triangles,
    welded,
  });
}

const told = (method: string): Call[] => calls.filter(([, each]) => each === method);

describe('what one layer has to know', () => {
  test('every mounted layer is told', () => {
    layers.mount(recorder('a'));
    layers.mount(recorder('b', { aid: true }));
    const view = model();
    layers.setPalette(PALETTES.light);
    layers.resize(300, 200, 2);
    layers.setModel(view);
    layers.modelSettled();
    layers.restore();
    layers.setKept(true);
    layers.paced(16);
    for (const [method, ...args] of [
      ['setPalette', PALETTES.light],
      ['resize', 300, 200, 2],
      ['modelSettled'],
      ['restore'],
      ['setKept', true],
      ['paced', 16],
    ] as const) {
      expect(told(method)).toEqual([
        ['a', method, ...args],
        ['b', method, ...args],
      ]);
    }
    expect(told('place').slice(-2)).toEqual([
      ['a', 'place', view.space, view],
      ['b', 'place', view.space, view],
    ]);
  });

  test('one that is mounted later is told at once', () => {
    const view = model();
    layers.setPalette(PALETTES.dark);
    layers.resize(300, 200, 1);
    layers.setModel(view);
    layers.mount(recorder('late'));
    expect(calls).toEqual([
      ['late', 'setPalette', PALETTES.dark],
      ['late', 'resize', 300, 200, 1],
      ['late', 'place', view.space, view],
    ]);
  });

  test('one that is gone is told nothing more, and is disposed of once', () => {
    const { unmount } = layers.mount(recorder('a'));
    expect(layers.group.children).toHaveLength(2);
    unmount();
    unmount();
    expect(told('dispose')).toHaveLength(1);
    expect(layers.group.children).toHaveLength(1);
    calls = [];
    layers.setPalette(PALETTES.light);
    layers.setModel(undefined);
    layers.dispose();
    expect(calls).toEqual([]);
  });

  test('the picture is drawn anew when a layer comes and when it goes', () => {
    const { unmount } = layers.mount(recorder('a'));
    expect(redraws).toBe(1);
    unmount();
    expect(redraws).toBe(2);
  });

  test('all go with the picture', () => {
    layers.mount(recorder('a'));
    layers.mount(recorder('b', { aid: true }));
    layers.dispose();
    expect(told('dispose').map(([id]) => id)).toEqual(['a', 'b']);
  });
});

describe('the space', () => {
  const own = ViewSpace.around({ positions: Float64Array.of(0, 0, 0, 8, 8, 8) });

  test('is a layer’s own while there is no model, and every layer is placed in it', () => {
    layers.mount(recorder('a'));
    const alone = layers.mount(recorder('b', { ownSpace: () => own }));
    expect(layers.space).toBe(own);
    expect(told('place').slice(-2)).toEqual([
      ['a', 'place', own, undefined],
      ['b', 'place', own, undefined],
    ]);
    const view = model();
    layers.setModel(view);
    expect(layers.space).toBe(view.space);
    layers.setModel(undefined);
    expect(layers.space).toBe(own);
    alone.unmount();
    expect(layers.space).toBe(ViewSpace.identity);
  });

  test('follows a layer that says its own is another, and stays where the model’s counts', () => {
    let space: ViewSpace | undefined;
    const { port } = layers.mount(recorder('a', { ownSpace: () => space }));
    expect(layers.space).toBe(ViewSpace.identity);
    space = own;
    port.settle();
    expect(layers.space).toBe(own);
    const view = model();
    layers.setModel(view);
    calls = [];
    space = undefined;
    port.settle();
    expect(layers.space).toBe(view.space);
    expect(calls).toEqual([]);
  });
});

test('aids are hidden while a picture to keep is made, the rest is not', () => {
  const [work, aid] = [new Group(), new Group()];
  layers.mount(recorder('work', { group: work }));
  layers.mount(recorder('aid', { group: aid, aid: true }));
  const seen = (group: Group): boolean => {
    let all = true;
    for (let at: Group['parent'] = group; at; at = at.parent) all &&= at.visible;
    return all;
  };
  layers.setKept(true);
  expect([seen(work), seen(aid)]).toEqual([true, false]);
  layers.setKept(false);
  expect([seen(work), seen(aid)]).toEqual([true, true]);
});

test('extents, shades and the wish to refine are those of the layers there are', () => {
  const shade = { id: 'veil' } as SurfaceShade;
  const { unmount } = layers.mount(recorder('a', { extent: () => [1, 2, 3], shade, refines: true }));
  layers.mount(recorder('b', { extent: () => Float32Array.of(4, 5, 6) }));
  expect([layers.extent(), layers.shades, layers.refine]).toEqual([[1, 2, 3, 4, 5, 6], [shade], true]);
  unmount();
  expect([layers.extent(), layers.shades, layers.refine]).toEqual([[4, 5, 6], [], false]);
});
