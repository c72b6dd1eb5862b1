import fc from 'fast-check';
import { Matrix4, Quaternion, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { ViewSpace } from '../../web/view/view-space';

const spaceOf = (upAxis: 'y' | 'z', scale = 1, at = 0): ViewSpace =>
  ViewSpace.around({
    positions: Float64Array.of(-1, -2, -3, 1, 2, 3).map((x) => x * scale + at),
    upAxis,
  });

test('the model fills a ball of radius one around the origin', () => {
  for (const up of ['y', 'z'] as const) {
    const space = spaceOf(up, 1e5, 1e7);
    expect(space.toView([1e7 + 1e5, 1e7 + 2e5, 1e7 + 3e5]).length()).toBeCloseTo(1, 9);
  }
});

test('there and back is where one was', () => {
  const near = fc.double({ min: -5, max: 5, noNaN: true });
  fc.assert(
    fc.property(near, near, near, fc.constantFrom('y' as const, 'z' as const), (x, y, z, up) => {
      const space = spaceOf(up);
      const back = space.toModel(space.toView([x, y, z]));
      for (const [k, c] of [x, y, z].entries()) expect(back[k]).toBeCloseTo(c, 9);
    }),
  );
});

test('what is up in the file is up on the screen', () => {
  expect(spaceOf('y').directionToView([0, 1, 0]).toArray()).toEqual([0, 1, 0]);
  expect(spaceOf('z').directionToView([0, 0, 1]).y).toBe(1);
});

test('a frame keeps its turn and size on the way through the view', () => {
  for (const up of ['y', 'z'] as const) {
    const space = spaceOf(up, 10, 100);
    const turn = new Quaternion(0.1, -0.5, 0.3, 0.7).normalize();
    const frame = new Matrix4().compose(new Vector3(101, 99, 120), turn, new Vector3(1, 2, 0.5));
    const [p, q, s] = [new Vector3(), new Quaternion(), new Vector3()];
    space.frameToView(frame, p, q, s);
    const back = space.frameToModel(p, q, s, new Matrix4());
    back.elements.forEach((x, i) => {
      expect(x).toBeCloseTo(frame.elements[i]!, 9);
    });
    // The drawn axes are the model's axes, turned upright.
    const drawn = new Vector3(1, 0, 0).applyQuaternion(q);
    const expected = space.directionToView(new Vector3(1, 0, 0).applyQuaternion(turn).toArray());
    expect(drawn.distanceTo(expected)).toBeLessThan(1e-9);
  }
});

test('a point, a line of equal points and nothing at all still give a usable space', () => {
  for (const positions of [Float64Array.of(3, 3, 3), Float64Array.of(), Float64Array.of(NaN, NaN, NaN)]) {
    const space = ViewSpace.around({ positions });
    expect(space.scale).toBe(1);
    expect(space.toModel(space.toView([1, 2, 3]))).toEqual([1, 2, 3]);
  }
});
