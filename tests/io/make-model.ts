import type { Model } from '../../web/core/model';

export function makeModel(positions: readonly number[], faces: readonly (readonly number[])[]): Model {
  const faceOffsets = new Uint32Array(faces.length + 1);
  faces.forEach((face, f) => {
    faceOffsets[f + 1] = faceOffsets[f]! + face.length;
  });
  return {
    name: 'made.obj',
    positions: Float64Array.from(positions),
    faceOffsets,
    faceVertices: Uint32Array.from(faces.flat()),
  };
}
