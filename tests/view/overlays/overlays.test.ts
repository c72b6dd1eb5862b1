// What holds for every overlay.

import { BufferGeometry, InstancedBufferGeometry, ShaderMaterial } from 'three';
import { expect, test } from 'vitest';
import type { Layer } from '../../../web/view/layer';
import { BOX } from '../../../web/view/overlays/box';
import { CONTROL_LINES } from '../../../web/view/overlays/control-lines';
import { FIELD } from '../../../web/view/overlays/field';
import { LOOPS } from '../../../web/view/overlays/loops';
import { MARKERS } from '../../../web/view/overlays/markers';
import { SUPPORT } from '../../../web/view/overlays/support';
import { PALETTES } from '../../../web/view/palette';
import { ViewSpace } from '../../../web/view/view-space';
import { heldBy, leftBy, made } from '../card';

const markers = made(MARKERS);
const loops = made(LOOPS);
const lines = made(CONTROL_LINES);
const field = made(FIELD);
const box = made(BOX);
const support = made(SUPPORT);
const arrow = { places: new Float32Array(3), vectors: Float32Array.of(0, 1, 0) };

const OVERLAYS: [name: string, layer: Layer, show: () => void][] = [
  [
    'markers',
    markers,
    () => markers.setMarkers([{ id: 'm', position: [1, 2, 3], visible: true, selected: false }]),
  ],
  [
    'loops',
    loops,
    () => loops.setLoops([{ points: Float64Array.of(1, 2, 3, 4, 5, 6, 7, 8, 9), tint: 'red', strong: true }]),
  ],
  [
    'control lines',
    lines,
    () =>
      lines.setLines([
        {
          id: 'c',
          points: [
            [1, 2, 3],
            [4, 5, 6],
          ],
          tint: 'blue',
          selected: true,
        },
      ]),
  ],
  [
    'field',
    field,
    () => {
      field.setField(arrow);
      field.setConstraints(arrow);
    },
  ],
  ['box', box, () => box.setVolume({ low: [1, 2, 3], high: [4, 5, 6] })],
  [
    'support',
    support,
    () =>
      support.setSupport({
        positions: Float64Array.of(0, 0, 1, 1, 0, 1, 0, 1, 1),
        triangles: Uint32Array.of(0, 1, 2),
      }),
  ],
];

/** Every number that says where something is drawn. The corners of lines are in no space. */
const drawn = (layer: Layer): number[] =>
  [...heldBy(layer)].flatMap((held) => {
    if (!(held instanceof BufferGeometry)) return [];
    const names = held instanceof InstancedBufferGeometry ? ['from', 'to'] : ['position'];
    return names.flatMap((name) => [...held.getAttribute(name).array]);
  });

test.each(OVERLAYS)('%s lie in the space they are placed in, and follow it to another', (_, layer, show) => {
  layer.place(ViewSpace.identity, undefined);
  show();
  const before = drawn(layer);
  expect(before.length).toBeGreaterThan(0);
  const shifted = ViewSpace.around({ positions: Float64Array.of(0, 0, 0, 20, 20, 20) });
  layer.place(shifted, undefined);
  const after = drawn(layer);
  expect(after).toHaveLength(before.length);
  after.forEach((x, i) => {
    expect(x).toBeCloseTo((before[i]! - 10) * shifted.scale, 5);
  });
  layer.place(ViewSpace.identity, undefined);
  expect(drawn(layer)).toEqual(before);
});

test.each(OVERLAYS)('%s leave nothing on the graphics card', (_, layer, show) => {
  layer.setPalette?.(PALETTES.dark);
  show();
  expect(heldBy(layer).size).toBeGreaterThan(1);
  expect(leftBy(layer)).toEqual([]);
});

test('markers and loops go with the model they are on', () => {
  const [marks, lines] = [made(MARKERS), made(LOOPS)];
  marks.setMarkers([{ id: 'm', position: [0, 0, 0], visible: true, selected: false }]);
  lines.setLoops([{ points: new Float64Array(9), strong: false }]);
  expect(marks.pickMarker(0, 0)).toBe('m');
  marks.place(ViewSpace.identity, {} as never);
  lines.place(ViewSpace.identity, {} as never);
  expect(marks.pickMarker(0, 0)).toBeNull();
  expect([marks.group.visible, lines.group.visible]).toEqual([false, false]);
});

test('a marker is met within reach, the nearest first, and never behind the eye or hidden', () => {
  const layer = made(MARKERS);
  const at = (id: string, x: number, z = 0, visible = true) =>
    ({ id, position: [x, 0, z], visible, selected: false }) as const;
  layer.setMarkers([at('a', 0), at('b', 0.1), at('behind', 0.3, 9), at('hidden', 0.5, 0, false)]);
  expect([2, 8, 23, 30, 50].map((x) => layer.pickMarker(x, 0))).toEqual(['a', 'b', 'b', null, null]);
});

test('markers and loops are drawn in the tints of the theme', () => {
  const [marks, lines] = [made(MARKERS), made(LOOPS)];
  const colours = (): string[] =>
    [...heldBy(marks), ...heldBy(lines)].flatMap((held) => {
      if (held instanceof ShaderMaterial && held.uniforms.colour)
        return String(held.uniforms.colour.value.getHex());
      return held instanceof InstancedBufferGeometry ? String(held.getAttribute('look').array) : [];
    });
  lines.setLoops([{ points: new Float64Array(9), tint: 'red', strong: false }]);
  const [dark, light] = [PALETTES.dark, PALETTES.light].map((palette) => {
    for (const layer of [marks, lines]) layer.setPalette?.(palette);
    return colours();
  });
  expect(dark).toHaveLength(3);
  dark!.forEach((colour, i) => {
    expect(colour).not.toBe(light![i]);
  });
});
