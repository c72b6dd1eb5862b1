import { Ray, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { ModelView } from '../../web/view/model-view';
import { Picker } from '../../web/view/picking';
import type { Vec3, ViewModel } from '../../web/view/types';
import { identityWeld, type Shape, sphere } from './shapes';

function modelOf({ positions, triangles }: Shape, upAxis: 'y' | 'z' = 'y'): ViewModel {
  const faceOffsets = Uint32Array.from({ length: triangles.length / 3 + 1 }, (_, i) => 3 * i);
  const welded = identityWeld(positions.length / 3);
  return { positions, triangles, faceOffsets, faceVertices: triangles, welded, upAxis };
}

const moved = ({ positions, triangles }: Shape, scale: number, by: Vec3): Shape => ({
  positions: positions.map((x, i) => scale * x + by[i % 3]!),
  triangles,
});

/** A ray in drawn units along a line of the model. */
function rayOf(view: ModelView, from: Vec3, along: Vec3): Ray {
  return new Ray(view.space.toView(from), view.space.directionToView(along, new Vector3()).normalize());
}

describe('a hit', () => {
  const offset: Vec3 = [1e8, -4e7, 3e7];
  for (const [name, scale, by] of [
    ['at the origin', 1, [0, 0, 0]],
    ['far from the origin', 1, offset],
    ['a micrometre in size', 1e-6, [0, 0, 0]],
  ] as const) {
    for (const up of ['y', 'z'] as const) {
      test(`is told in the model's own coordinates: ${name}, ${up} up`, () => {
        const view = new ModelView(modelOf(moved(sphere(32), scale, by), up));
        const from: Vec3 = [by[0] + 5 * scale, by[1] + 0.2 * scale, by[2] + 0.3 * scale];
        const hit = new Picker(view).pick(rayOf(view, from, [-1, 0, 0]))!;
        const inUnits = hit.point.map((x, k) => (x - by[k]!) / scale);
        expect(inUnits[0]).toBeCloseTo(Math.sqrt(1 - 0.04 - 0.09), 2);
        expect(inUnits[1]).toBeCloseTo(0.2, 5);
        expect(inUnits[2]).toBeCloseTo(0.3, 5);
        expect(hit.distance / scale).toBeCloseTo(5 - inUnits[0]!, 4);
        for (let k = 0; k < 3; k++) expect(hit.normal[k]).toBeCloseTo(inUnits[k]!, 1);
      });
    }
  }

  test("names a triangle of the caller's list and its vertex nearest to the point", () => {
    const model = modelOf(sphere(20));
    const before = model.triangles.slice();
    const view = new ModelView(model);
    const hit = new Picker(view).pick(rayOf(view, [0.1, 5, 0.2], [0, -1, 0]))!;
    expect(model.triangles).toEqual(before);
    const corners = [...model.triangles.subarray(3 * hit.triangle, 3 * hit.triangle + 3)];
    const gap = (v: number): number =>
      Math.hypot(...hit.point.map((x, k) => x - model.positions[3 * v + k]!));
    expect(corners).toContain(hit.vertex);
    for (const v of corners) expect(gap(hit.vertex)).toBeLessThanOrEqual(gap(v));
  });

  test('follows the pose once it has settled', () => {
    const model = modelOf(sphere(20));
    const view = new ModelView(model);
    const picker = new Picker(view);
    const ray = rayOf(view, [0, 5, 0], [0, -1, 0]);
    expect(picker.pick(ray)!.point[1]).toBeCloseTo(1, 6);
    view.setPositions(model.positions.map((x, i) => (i % 3 === 1 ? 0.5 * x : x)));
    picker.settle();
    expect(picker.pick(ray)!.point[1]).toBeCloseTo(0.5, 6);
  });

  test('is nothing beside the model, and nothing where there is no triangle', () => {
    const view = new ModelView(modelOf(sphere(4)));
    expect(new Picker(view).pick(rayOf(view, [3, 5, 0], [0, -1, 0]))).toBeNull();
    const dots = new ModelView(
      modelOf({ positions: Float64Array.of(0, 0, 0), triangles: new Uint32Array() }),
    );
    expect(new Picker(dots).pick(rayOf(dots, [0, 5, 0], [0, -1, 0]))).toBeNull();
  });
});

test('vertices that are not finite are drawn at the centre and disturb nothing else', () => {
  const { positions, triangles } = sphere(4);
  positions[3] = Number.NaN;
  positions[7] = Infinity;
  const view = new ModelView(modelOf({ positions, triangles }));
  expect(view.places().every(Number.isFinite)).toBe(true);
  expect(view.space.scale).toBeGreaterThan(0.4);
});
