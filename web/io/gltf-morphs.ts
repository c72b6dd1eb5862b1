import { type Model, withPositions } from '../core/model';
import { F32 } from './gltf-accessors';
import { ARRAY, buildGltf, type GltfAddition } from './gltf-build';
import { packGltf } from './gltf-container';
import { ownRig } from './gltf-rig-write';
import { vertexNormals } from './normals';

/**
 * A model with others of the same vertices as its morph targets (Khronos glTF 2.0 specification, 3.7.2.2): a program that
 * opens it has a slider for each, called after its model, and for each morph that the model has. At rest all are 0. Its joints come along.
 *
 * @param others  each with as many vertices as `model`, in their own places
 */
export function writeGltfMorphs(model: Model, others: readonly Model[], format: 'glb' | 'gltf'): Uint8Array {
  const shapes = others.map((other) => ({ ...other, name: other.name.replace(/\.[^.]*$/, '') }));
  const { json, binary } = buildGltf(
    model,
    additionOf(model, [...shapes, ...ownShapes(model)]),
    ownRig(model),
  );
  return packGltf(json, binary, format);
}

/** The morphs that a model has, as an addition to its document; `undefined`: none. */
export const ownMorphs = (model: Model): GltfAddition | undefined =>
  model.morphs?.length ? additionOf(model, ownShapes(model)) : undefined;

const ownShapes = (model: Model): Model[] =>
  (model.morphs ?? []).map(({ name, offsets }) => ({
    ...withPositions(
      model,
      model.positions.map((x, at) => x + offsets[at]!),
    ),
    name,
  }));

const additionOf =
  (model: Model, others: readonly Model[]): GltfAddition =>
  ({ binary, vertex, origin }) => {
    const normals = vertexNormals(model);
    const targets = others.map((other) => {
      const position = differences(vertex, (at) => {
        const from = origin[at % 3]!;
        return Math.fround(other.positions[at]! - from) - Math.fround(model.positions[at]! - from);
      });
      for (const value of position.values) binary.out.f32(value);
      const { min, max } = position;
      const POSITION = binary.add(vertex.length, { componentType: F32, type: 'VEC3', min, max }, ARRAY);
      const turned = vertexNormals(other);
      const normal = differences(vertex, (at) => turned[at]! - normals[at]!);
      for (const value of normal.values) binary.out.f32(value);
      return { POSITION, NORMAL: binary.add(vertex.length, { componentType: F32, type: 'VEC3' }, ARRAY) };
    });
    return {
      targets,
      targetNames: others.map(({ name }) => name),
    };
  };

/** Three numbers for each row, and their bounds; what is not finite does not move. */
function differences(vertex: Uint32Array, difference: (at: number) => number) {
  const values = new Float32Array(3 * vertex.length);
  const min = [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY];
  const max = [Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (const [row, v] of vertex.entries())
    for (let k = 0; k < 3; k++) {
      const value = Math.fround(difference(3 * v + k));
      const written = Number.isFinite(value) ? value : 0;
      values[3 * row + k] = written;
      min[k] = Math.min(min[k]!, written);
      max[k] = Math.max(max[k]!, written);
    }
  return { values, min, max };
}
