import { bytes } from './support';

export const FLOATS = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0);
export const UVS = Float32Array.of(0, 0, 1, 0, 0, 1, 1, 1);
export const NORMALS = Float32Array.of(0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1);

export interface Piece {
  readonly values: Float32Array | Uint16Array | Uint8Array | Int16Array | Uint32Array;
  readonly type: string;
  readonly normalized?: boolean;
}

const TYPES = new Map<unknown, number>([
  [Float32Array, 5126],
  [Uint32Array, 5125],
  [Uint16Array, 5123],
  [Int16Array, 5122],
  [Uint8Array, 5121],
]);
const WIDTH: Record<string, number> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };

/** A .gltf whose accessors hold `pieces`, one buffer view each, with the rest of the document as given. */
export function gltf(pieces: readonly Piece[], rest: object): Uint8Array {
  const views: object[] = [];
  const content: number[] = [];
  const accessors = pieces.map(({ values, type, normalized }, bufferView) => {
    while (content.length % 4) content.push(0);
    views.push({ buffer: 0, byteOffset: content.length, byteLength: values.byteLength });
    content.push(...new Uint8Array(values.buffer, values.byteOffset, values.byteLength));
    const componentType = TYPES.get(values.constructor);
    return {
      bufferView,
      componentType,
      type,
      count: values.length / WIDTH[type]!,
      ...(normalized && { normalized }),
    };
  });
  const uri = `data:application/octet-stream;base64,${Buffer.from(content).toString('base64')}`;
  return bytes(
    JSON.stringify({
      asset: { version: '2.0' },
      buffers: [{ byteLength: content.length, uri }],
      bufferViews: views,
      accessors,
      ...rest,
    }),
  );
}

export const POSITION: Piece = { values: FLOATS, type: 'VEC3' };
export const one = (primitive: object, node: object = {}) => ({
  nodes: [{ mesh: 0, ...node }],
  meshes: [{ primitives: [{ attributes: { POSITION: 0 }, ...primitive }] }],
});
