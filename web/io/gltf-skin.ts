import type { Model } from '../core/model';
import { JOINT, type Skin } from '../core/skin';
import { compose, invert } from './affine';
import { F32 } from './gltf-accessors';
import { type BufferBuilder, buildGltf, type GltfAddition } from './gltf-build';
import { packGltf } from './gltf-container';
import { FIRST_JOINT, skeletonOf, writeInfluences } from './gltf-rig-write';
import type { GltfNode } from './gltf-schema';

/**
 * A model with joints, as glTF's skins have it: bound at rest, opened in the pose that is shown, with the poses that are
 * kept as an animation. It is a document of its own, whatever the model came from. Joints are not children of one another:
 * each carries its own stretch, and a stretched parent would skew its children.
 *
 * @param model  at rest
 */
export function writeSkinnedGltf(model: Model, skin: Skin, format: 'glb' | 'gltf'): Uint8Array {
  const { json, binary } = buildGltf(model, additionOf(skin));
  return packGltf(json, binary, format);
}

const additionOf =
  (skin: Skin): GltfAddition =>
  ({ binary, vertex, origin, placement }) => {
    const attributes = writeInfluences(binary, { ...skin, influences: 4 }, vertex);
    const rest = lessOrigin(skin.rest, origin);
    const posed = lessOrigin(skin.posed, origin);
    const inverseBindMatrices = writeInverses(binary, rest);
    const animation = writeAnimation(binary, skin, posed, origin);
    const joints = skin.joints.map((name, joint) => ({ name, ...nodeAt(posed, joint) }));
    const all = joints.map((_, joint) => FIRST_JOINT + joint);
    const { nodes, more } = skeletonOf(joints, all, inverseBindMatrices, placement);
    return { attributes, nodes, more: { ...more, ...animation } };
  };

function writeInverses(binary: BufferBuilder, rest: Float64Array): number {
  const count = rest.length / JOINT;
  for (let joint = 0; joint < count; joint++) {
    const { translation, rotation, scale } = nodeAt(rest, joint);
    for (const x of invert(compose(translation, rotation, scale))!) binary.out.f32(x);
  }
  return binary.add(count, { componentType: F32, type: 'MAT4' });
}

/** Where in a joint's numbers each of its paths is. */
const PATHS = [
  { path: 'translation', from: 0, size: 3, type: 'VEC3' },
  { path: 'rotation', from: 3, size: 4, type: 'VEC4' },
  { path: 'scale', from: 7, size: 3, type: 'VEC3' },
] as const;

/** What stays as it is in the pose that is shown is left out. */
function writeAnimation(
  binary: BufferBuilder,
  { keys, joints }: Skin,
  posed: Float64Array,
  origin: readonly number[],
) {
  if (keys.length === 0) return {};
  for (const { time } of keys) binary.out.f32(time);
  const [first, last] = [keys[0]!, keys.at(-1)!].map(({ time }) => Math.fround(time));
  const range = { min: [first!], max: [last!] };
  const input = binary.add(keys.length, { componentType: F32, type: 'SCALAR', ...range });
  const shifted = keys.map((key) => lessOrigin(key.joints, origin));
  const samplers: object[] = [];
  const channels: object[] = [];
  for (let joint = 0; joint < joints.length; joint++)
    for (const { path, from, size, type } of PATHS) {
      const at = JOINT * joint + from;
      const stays = shifted.every((key) => same(key, posed, at, size));
      if (stays) continue;
      for (const key of shifted) for (let k = at; k < at + size; k++) binary.out.f32(key[k]!);
      const output = binary.add(keys.length, { componentType: F32, type });
      channels.push({ sampler: samplers.length, target: { node: FIRST_JOINT + joint, path } });
      samplers.push({ input, output, interpolation: 'LINEAR' });
    }
  return channels.length > 0 ? { animations: [{ name: 'poses', samplers, channels }] } : {};
}

/** In single precision: it is what is written. */
function same(a: Float64Array, b: Float64Array, at: number, size: number): boolean {
  for (let k = at; k < at + size; k++) if (Math.fround(a[k]!) !== Math.fround(b[k]!)) return false;
  return true;
}

function nodeAt(joints: Float64Array, joint: number) {
  const at = (from: number, to: number) => [...joints.subarray(JOINT * joint + from, JOINT * joint + to)];
  return { translation: at(0, 3), rotation: at(3, 7), scale: at(7, 10) } satisfies GltfNode;
}

/** Joints as positions are written: less the place that those are told from. */
function lessOrigin(joints: Float64Array, origin: readonly number[]): Float64Array {
  const result = joints.slice();
  for (let at = JOINT; at < result.length; at += JOINT)
    for (let k = 0; k < 3; k++) result[at + k]! -= origin[k]!;
  return result;
}
