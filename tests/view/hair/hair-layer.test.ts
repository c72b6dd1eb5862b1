import { describe, expect, test } from 'vitest';
import { HAIR } from '../../../web/view/hair/hair-layer';
import { ModelView } from '../../../web/view/model-view';
import { ViewSpace } from '../../../web/view/view-space';
import { contextOf, heldBy, leftBy, made } from '../card';
import { identityWeld, sphere } from '../shapes';
import { straight, strandsOf } from './strands';

const strands = strandsOf([straight([0, 1, 0], [0, 3, 0], 5), straight([1, 0, 0], [4, 0, 0], 5)], {
  origin: [10, 0, 0],
});

function head(): ModelView {
  const { positions, triangles } = sphere(3);
  const faceOffsets = Uint32Array.from({ length: triangles.length / 3 + 1 }, (_, i) => 3 * i);
  const welded = identityWeld(positions.length / 3);
  return new ModelView({ positions, triangles, faceOffsets, faceVertices: triangles, welded });
}

describe('a head of hair', () => {
  test('shades surfaces, makes room and refines the picture while it is shown, and only then', () => {
    const layer = made(HAIR);
    const state = () => [layer.shade !== undefined, layer.refines, layer.extent!().length > 0];
    layer.place(ViewSpace.identity, undefined);
    expect(state()).toEqual([false, false, false]);
    layer.setHair(strands);
    expect(state()).toEqual([true, true, true]);
    layer.setHairOptions({ show: false });
    expect(state()).toEqual([false, false, false]);
    layer.setHairOptions({ show: true });
    expect(state()).toEqual([true, true, true]);
    layer.setHair(null);
    expect(state()).toEqual([false, false, false]);
  });

  test('lies where its strands are, in whatever space it is placed', () => {
    const layer = made(HAIR);
    layer.place(ViewSpace.identity, undefined);
    layer.setHair(strands);
    const places = (): number[] => Array.from(layer.extent!());
    const before = places();
    expect(before.slice(0, 3)).toEqual([10, 1, 0]);
    const model = head();
    const space = ViewSpace.around({ positions: Float64Array.of(0, 0, 0, 20, 20, 20) });
    layer.place(space, model);
    places().forEach((x, i) => {
      expect(x).toBeCloseTo((before[i]! - 10) * space.scale, 6);
    });
  });

  test('has a space around itself to be drawn in alone, another one for other strands', () => {
    let settled = 0;
    const layer = HAIR.make(contextOf({ settle: () => settled++ }));
    expect(layer.ownSpace!()).toBeUndefined();
    layer.setHair(strands);
    expect(settled).toBe(1);
    const own = layer.ownSpace!()!;
    expect(own.centre).toEqual([12, 1.5, 0]);
    expect(layer.ownSpace!()).toBe(own);
    layer.setHair(strandsOf([straight([0, 0, 0], [0, 1, 0], 2)]));
    expect(layer.ownSpace!()!.centre).toEqual([0, 0.5, 0]);
    layer.setHair(null);
    expect(layer.ownSpace!()).toBeUndefined();
  });

  test('leaves nothing on the graphics card', () => {
    const layer = made(HAIR);
    layer.place(ViewSpace.identity, undefined);
    layer.setHair(strands);
    // Ribbons and their material, points, light of points and of places, three opacity maps.
    expect(heldBy(layer).size).toBeGreaterThanOrEqual(8);
    expect(leftBy(layer)).toEqual([]);
  });
});
