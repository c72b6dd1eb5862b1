import * as v from 'valibot';

// glTF 2.0 as far as geometry is concerned (Khronos glTF 2.0 specification, section 5). Everything else in a
// document is carried along unread.

const index = v.pipe(v.number(), v.integer(), v.minValue(0));
const numbers = (count: number) => v.pipe(v.array(v.number()), v.length(count));
const attributes = v.record(v.string(), index);
const extensions = v.record(v.string(), v.unknown());

const accessor = v.looseObject({
  bufferView: v.exactOptional(index),
  byteOffset: v.exactOptional(index),
  componentType: index,
  normalized: v.exactOptional(v.boolean()),
  count: index,
  type: v.string(),
  min: v.exactOptional(v.array(v.number())),
  max: v.exactOptional(v.array(v.number())),
  sparse: v.exactOptional(
    v.looseObject({
      count: index,
      indices: v.looseObject({ bufferView: index, byteOffset: v.exactOptional(index), componentType: index }),
      values: v.looseObject({ bufferView: index, byteOffset: v.exactOptional(index) }),
    }),
  ),
});

const bufferView = v.looseObject({
  buffer: index,
  byteOffset: v.exactOptional(index),
  byteLength: index,
  byteStride: v.exactOptional(index),
  target: v.exactOptional(index),
  extensions: v.exactOptional(extensions),
});

const primitive = v.looseObject({
  attributes,
  indices: v.exactOptional(index),
  material: v.exactOptional(index),
  mode: v.exactOptional(index),
  targets: v.exactOptional(v.array(attributes)),
  /** `name`: the group's, where it is not the node's. */
  extras: v.exactOptional(v.unknown()),
  extensions: v.exactOptional(extensions),
});

const name = v.exactOptional(v.string());

const mesh = v.looseObject({
  name,
  primitives: v.array(primitive),
  /** `targetNames`: of the morph targets. */
  extras: v.exactOptional(v.unknown()),
});

const node = v.looseObject({
  name,
  mesh: v.exactOptional(index),
  skin: v.exactOptional(index),
  children: v.exactOptional(v.array(index)),
  matrix: v.exactOptional(numbers(16)),
  translation: v.exactOptional(numbers(3)),
  rotation: v.exactOptional(numbers(4)),
  scale: v.exactOptional(numbers(3)),
  extensions: v.exactOptional(extensions),
});

export const gltfSchema = v.looseObject({
  asset: v.looseObject({ version: v.string() }),
  scene: v.exactOptional(index),
  scenes: v.exactOptional(v.array(v.looseObject({ nodes: v.exactOptional(v.array(index)) }))),
  nodes: v.exactOptional(v.array(node)),
  meshes: v.exactOptional(v.array(mesh)),
  accessors: v.exactOptional(v.array(accessor)),
  bufferViews: v.exactOptional(v.array(bufferView)),
  buffers: v.exactOptional(v.array(v.looseObject({ uri: v.exactOptional(v.string()), byteLength: index }))),
  materials: v.exactOptional(v.array(v.looseObject({ name }))),
  skins: v.exactOptional(
    v.array(v.looseObject({ joints: v.array(index), inverseBindMatrices: v.exactOptional(index) })),
  ),
  extensionsUsed: v.exactOptional(v.array(v.string())),
  extensionsRequired: v.exactOptional(v.array(v.string())),
});

export type GltfJson = v.InferOutput<typeof gltfSchema>;
export type GltfAccessor = v.InferOutput<typeof accessor>;
export type GltfBufferView = v.InferOutput<typeof bufferView>;
export type GltfPrimitive = v.InferOutput<typeof primitive>;
export type GltfNode = v.InferOutput<typeof node>;
