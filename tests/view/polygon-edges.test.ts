import { describe, expect, test } from 'vitest';
import { polygonEdges } from '../../web/view/polygon-edges';

describe('the wireframe', () => {
  const edgesOf = (faces: readonly (readonly number[])[], count: number): string[] => {
    const offsets = [0];
    for (const face of faces) offsets.push(offsets.at(-1)! + face.length);
    const edges = polygonEdges(Uint32Array.from(offsets), Uint32Array.from(faces.flat()), count);
    return Array.from({ length: edges.length / 2 }, (_, e) => `${edges[2 * e]}-${edges[2 * e + 1]}`).sort();
  };

  test('shows a quad as four edges, and an edge of two faces once', () => {
    const faces = [
      [0, 1, 2, 3],
      [3, 2, 4],
    ];
    expect(edgesOf(faces, 5)).toEqual(['0-1', '0-3', '1-2', '2-3', '2-4', '3-4']);
  });

  test('passes over repeated corners and vertices that are not there', () => {
    expect(edgesOf([[0, 0, 1, 9]], 2)).toEqual(['0-1']);
  });
});
