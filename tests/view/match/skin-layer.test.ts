import { LineSegments, Mesh, type MeshStandardMaterial } from 'three';
import { expect, test } from 'vitest';
import type { LayerContext } from '../../../web/view/layer';
import { edgesOf, SKIN } from '../../../web/view/match/skin-layer';
import type { ModelView } from '../../../web/view/model-view';
import { ViewSpace } from '../../../web/view/view-space';
import { box } from '../shapes';

test('every edge is there once', () => {
  const { triangles } = box();
  const edges = edgesOf(triangles);
  // Euler: a closed surface of 8 vertices and 12 triangles has 18.
  expect(edges).toHaveLength(36);
  const keys = Array.from({ length: 18 }, (_, e) =>
    [edges[2 * e]!, edges[2 * e + 1]!].sort((a, b) => a - b).join(),
  );
  expect(new Set(keys).size).toBe(18);
});

test('alone a skin hides its model, until it is gone', () => {
  const layer = SKIN.make({ redraw: () => {} } as unknown as LayerContext);
  const model = { mesh: new Mesh() } as unknown as ModelView;
  const look = { skin: box(), alone: true, edges: true };
  layer.place(ViewSpace.identity, model);
  expect(layer.group.visible).toBe(false);
  layer.setSkin(look);
  expect([layer.group.visible, model.mesh.visible]).toEqual([true, false]);
  layer.setSkin({ ...look, alone: false, edges: false });
  expect(model.mesh.visible).toBe(true);
  expect(layer.group.children.find((child) => child instanceof LineSegments)!.visible).toBe(false);
  layer.setSkin(look);
  layer.setSkin(null);
  expect([layer.group.visible, model.mesh.visible]).toEqual([false, true]);
  layer.setSkin(look);
  layer.dispose();
  expect(model.mesh.visible).toBe(true);
});

test('coloured it goes from pale to red with the distance', () => {
  const layer = SKIN.make({ redraw: () => {} } as unknown as LayerContext);
  layer.place(ViewSpace.identity, { mesh: new Mesh() } as unknown as ModelView);
  layer.setSkin({ skin: box(), alone: true, edges: false, heat: Float32Array.of(0, 1, 0, 0, 0, 0, 0, 0) });
  const mesh = layer.group.children[0] as Mesh;
  const colours = mesh.geometry.getAttribute('color');
  const spread = (v: number) => colours.getX(v) - colours.getZ(v);
  expect((mesh.material as MeshStandardMaterial).vertexColors).toBe(true);
  expect(spread(0)).toBeLessThan(0.05);
  expect(spread(1)).toBeGreaterThan(0.3);
  layer.dispose();
});
