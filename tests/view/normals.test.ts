import { describe, expect, test } from 'vitest';
import { facesInwards, isClosed, VertexNormals } from '../../web/view/normals';
import { box, identityWeld, sphere } from './shapes';

const normalsOf = (positions: Float64Array, triangles: Uint32Array, welded: Int32Array): Float32Array => {
  const out = new Float32Array(positions.length);
  new VertexNormals(triangles, welded).compute(Float32Array.from(positions), out);
  return out;
};

describe('smooth normals', () => {
  test('those of a cube point along its diagonals however its squares were cut', () => {
    const cube = box();
    const normals = normalsOf(cube.positions, cube.triangles, identityWeld(8));
    for (let i = 0; i < normals.length; i++) {
      expect(Math.abs(normals[i]!)).toBeCloseTo(1 / Math.sqrt(3), 3);
      expect(Math.sign(normals[i]!)).toBe(Math.sign(cube.positions[i]!));
    }
  });

  test('those of a sphere are its radii', () => {
    const ball = sphere(24);
    const normals = normalsOf(ball.positions, ball.triangles, identityWeld(ball.positions.length / 3));
    for (let v = 0; v < normals.length; v += 3) {
      const along = [0, 1, 2].reduce((sum, k) => sum + normals[v + k]! * ball.positions[v + k]!, 0);
      expect(along).toBeGreaterThan(0.997);
    }
  });

  test('a seam in the file is no crease: welded twins share one normal', () => {
    const positions = Float64Array.of(0, 0, 0, 0, 1, 0, -1, 0, -1, 0, 0, 0, 0, 1, 0, 1, 0, -1);
    const triangles = Uint32Array.of(0, 1, 2, 4, 3, 5);
    const normals = normalsOf(positions, triangles, Int32Array.of(0, 1, 2, 0, 1, 3));
    expect([...normals.subarray(0, 6)]).toEqual([...normals.subarray(9, 15)]);
    expect(normals[0]).toBeCloseTo(0, 6);
  });

  test('triangles without area and vertices without triangles still get a unit normal', () => {
    const positions = Float64Array.of(0, 0, 0, 1, 0, 0, 2, 0, 0, 5, 5, 5);
    const normals = normalsOf(positions, Uint32Array.of(0, 1, 2, 0, 0, 1), Int32Array.of(0, 1, 2, -1));
    for (let v = 0; v < 12; v += 3) expect([...normals.subarray(v, v + 3)]).toEqual([0, 1, 0]);
  });
});

describe('which way a surface faces', () => {
  test('a cube is closed and faces outwards, its reverse inwards', () => {
    const { positions, triangles } = box();
    const drawn = Float32Array.from(positions);
    const reversed = Uint32Array.from(triangles).reverse();
    expect(isClosed(triangles, identityWeld(8))).toBe(true);
    expect(facesInwards(drawn, triangles)).toBe(false);
    expect(facesInwards(drawn, reversed)).toBe(true);
  });

  test('a cube without one triangle, or with one turned over, is not closed', () => {
    const { triangles } = box();
    expect(isClosed(triangles.slice(3), identityWeld(8))).toBe(false);
    const turned = Uint32Array.from(
      [...triangles.subarray(0, 3)].reverse().concat([...triangles.subarray(3)]),
    );
    expect(isClosed(turned, identityWeld(8))).toBe(false);
  });
});
