import { Mesh, Points } from 'three';
import { expect, test } from 'vitest';
import { dotSize, isSoup } from '../../web/view/loose';
import { ModelView } from '../../web/view/model-view';
import { identityWeld, sphere } from './shapes';

const ball = sphere(16);
const count = ball.positions.length / 3;

/** The same triangles, each with corners of its own. */
const soup = {
  positions: Float64Array.from(
    [...ball.triangles].flatMap((v) => [...ball.positions.subarray(3 * v, 3 * v + 3)]),
  ),
  triangles: Uint32Array.from(ball.triangles.keys()),
};

const viewOf = (shape: typeof ball, welded: Int32Array, hasFaces: boolean) =>
  new ModelView({
    positions: shape.positions,
    triangles: shape.triangles,
    faceOffsets: hasFaces
      ? Uint32Array.from({ length: shape.triangles.length / 3 + 1 }, (_, f) => 3 * f)
      : Uint32Array.of(0),
    faceVertices: hasFaces ? shape.triangles : new Uint32Array(),
    welded,
  });

test('a soup is told from a surface, welded or not, and from a sheet', () => {
  expect(isSoup(ball.triangles, identityWeld(count))).toBe(false);
  expect(isSoup(soup.triangles, identityWeld(soup.triangles.length))).toBe(true);
  // As STL files have them: the corners of neighbours are in the same place.
  expect(isSoup(soup.triangles, Int32Array.from(ball.triangles))).toBe(false);
  expect(isSoup(Uint32Array.of(0, 1, 2, 3, 4, 5), identityWeld(6))).toBe(false);
});

test('dots are as large as points are apart, whatever the unit', () => {
  const places = Float32Array.from(ball.positions);
  const size = dotSize(places, ball.triangles);
  // An even share of the unit sphere.
  const gap = Math.sqrt((4 * Math.PI) / count);
  expect(size).toBeGreaterThan(0.75 * gap);
  expect(size).toBeLessThan(gap);
  expect(
    dotSize(
      places.map((x) => 100 * x),
      ball.triangles,
    ),
  ).toBeCloseTo(100 * size, 4);
});

test('points are drawn as dots and throw no shadows on each other; what is picked is the surface through them', () => {
  const view = viewOf(ball, identityWeld(count), false);
  expect(view.mesh).toBeInstanceOf(Points);
  expect(view.mesh.geometry.getIndex()).toBeNull();
  expect(view.surface.getIndex()!.count).toBe(ball.triangles.length);
  expect(view.dotSize).toBeGreaterThan(0);
  expect([view.insideUnknown, view.mesh.castShadow, view.mesh.receiveShadow]).toEqual([true, false, false]);
  view.setHeat(new Float32Array(count), [0, 1]);
  expect(view.mesh.geometry.getAttribute('heat')).toBe(view.geometry.getAttribute('heat'));
  view.dispose();
});

test('a surface has an inside, a soup none that anybody knows', () => {
  const whole = viewOf(ball, identityWeld(count), true);
  expect(whole.mesh).toBeInstanceOf(Mesh);
  expect([whole.dotSize, whole.insideUnknown, whole.mesh.receiveShadow]).toEqual([0, false, true]);
  const loose = viewOf(soup, identityWeld(soup.triangles.length), true);
  expect(loose.mesh).toBeInstanceOf(Mesh);
  expect([loose.dotSize, loose.insideUnknown, loose.mesh.receiveShadow]).toEqual([0, true, false]);
});
