import { expect, test } from 'vitest';
import { openLoops } from '../../../web/tools/merge/loops';
import { featureWithin, loopsTouched, tidied } from '../../../web/tools/merge/marks';
import { verticesThrough } from '../../../web/tools/merge/through';
import { MeshGraph } from '../../../web/tools/mesh-graph';
import { sheet } from './shapes';

const SIDE = 21;
const flat = sheet(SIDE, SIDE);
const graph = new MeshGraph(flat);
const within = (holds: (x: number, y: number) => boolean): Uint32Array =>
  Uint32Array.from(flat.welded.keys()).filter((v) => holds(v % SIDE, Math.floor(v / SIDE)));
const round = (radius: number, x = 10, y = 10) => within((a, b) => Math.hypot(a - x, b - y) <= radius);

test('the feature of a patch is its middle, and the rest is one ring around it', () => {
  const region = round(7);
  const feature = featureWithin(graph, region, flat.positions);
  expect(feature).toContain(10 * SIDE + 10);
  expect(feature.length).toBeGreaterThan(20);
  const inside = new Set(feature);
  const ring = region.filter((v) => !inside.has(v));
  expect(graph.flood(ring[0]!, (v) => ring.includes(v))).toEqual(ring);
});

test('what lies in a hole of the feature belongs to it', () => {
  const region = round(8);
  const feature = featureWithin(graph, region, flat.positions);
  const outside = new Set(region.filter((v) => !feature.includes(v)));
  expect(graph.flood(0, (v) => !feature.includes(v)).filter((v) => outside.has(v))).toHaveLength(
    outside.size,
  );
});

test('a mark that covers everything has no edge, and so no middle', () => {
  expect(
    featureWithin(
      graph,
      within(() => true),
      flat.positions,
    ),
  ).toHaveLength(0);
});

test('a rough mark becomes one patch: holes are filled, crumbs are left out', () => {
  const holed = within((x, y) => Math.hypot(x - 10, y - 10) <= 6 && (x !== 9 || y !== 11));
  const crumbs = Uint32Array.from([0, 1, ...holed, SIDE * SIDE - 1]).sort();
  expect(tidied(graph, crumbs, SIDE * SIDE)).toEqual(round(6));
});

test('a mark touches the openings it has a vertex of', () => {
  const surface = sheet(SIDE, SIDE, (x, y) => x === 10 && y === 10);
  const loops = openLoops(surface);
  expect(loopsTouched(loops, round(2)).map(({ length }) => length)).toEqual([4]);
  expect(loopsTouched(loops, round(2, 5, 5))).toEqual([]);
});

test('a brush that goes through takes both sides of what is thin, and nothing far behind', () => {
  const layers = [0, -1, -9].flatMap((z) => [0, 1, 5].map((x) => [x, 0, z]));
  const hit = { point: [0, 0, 0], normal: [0, 0, 1], triangle: 0, vertex: 0, distance: 100 } as const;
  const camera = { position: [0, 0, 100], target: [0, 0, 0], orthographic: false } as const;
  expect([...verticesThrough(Float64Array.from(layers.flat()), hit, 1.2, camera)]).toEqual([0, 1, 3, 4]);
});
