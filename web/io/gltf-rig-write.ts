import { type Affine, IDENTITY, multiply } from '../core/affine';
import type { Model } from '../core/model';
import { quaternionOf } from '../core/quaternion';
import type { Rig } from '../core/rig';
import { compose, determinant, invert } from './affine';
import { F32, U16 } from './gltf-accessors';
import { ARRAY, type BufferBuilder, type GltfAddition } from './gltf-build';
import type { GltfNode } from './gltf-schema';

/** Behind the node with the mesh: what holds the joints that hang from none, the joints. */
const SKELETON = 1;
export const FIRST_JOINT = 2;
const SET = 4;

/** The joints of a model as an addition to its document: nodes in their hierarchy, a skin; `undefined`: none. */
export const ownRig = ({ rig }: Model): GltfAddition | undefined => rig && additionOf(rig);

const additionOf =
  (rig: Rig): GltfAddition =>
  ({ binary, vertex, origin, placement }) => {
    const attributes = writeInfluences(binary, rig, vertex);
    const { locals, inverses } = placesOf(rig, origin);
    for (const inverse of inverses) for (const x of inverse) binary.out.f32(x);
    const inverseBindMatrices = binary.add(rig.joints.length, { componentType: F32, type: 'MAT4' });
    const children: number[][] = rig.joints.map(() => []);
    const roots: number[] = [];
    for (const [joint, { parent }] of rig.joints.entries())
      (children[parent] ?? roots).push(FIRST_JOINT + joint);
    const joints = rig.joints.map(({ name }, joint) => ({
      name,
      ...locals[joint]!,
      ...(children[joint]!.length > 0 && { children: children[joint]! }),
    }));
    return { attributes, ...skeletonOf(joints, roots, inverseBindMatrices, placement) };
  };

/**
 * The nodes of a skinned mesh and its skin.
 *
 * @param joints  a node each, in the order of the matrices. @param roots  numbers of the nodes that hang from no other joint
 */
export function skeletonOf(
  joints: readonly GltfNode[],
  roots: number[],
  inverseBindMatrices: number,
  placement: Parameters<GltfAddition>[0]['placement'],
): Required<Pick<ReturnType<GltfAddition>, 'nodes' | 'more'>> {
  const numbers = joints.map((_, joint) => FIRST_JOINT + joint);
  return {
    // A skinned mesh ignores its node: what places it places the skeleton.
    nodes: ({ translation: _t, rotation: _r, scale: _s, ...mesh }) => ({
      nodes: [{ ...mesh, skin: 0 }, { name: 'skeleton', children: roots, ...placement }, ...joints],
      shown: [0, SKELETON],
    }),
    more: { skins: [{ joints: numbers, skeleton: SKELETON, inverseBindMatrices }] },
  };
}

/** Attributes of joints and weights, a set for each four of a vertex. */
export function writeInfluences(
  binary: BufferBuilder,
  { influences, indices, weights }: Pick<Rig, 'influences' | 'indices' | 'weights'>,
  vertex: Uint32Array,
): Record<string, number> {
  const attributes: Record<string, number> = {};
  for (let set = 0; SET * set < influences; set++) {
    const first = (v: number) => influences * v + SET * set;
    for (const v of vertex) for (let k = 0; k < SET; k++) binary.out.u16(indices[first(v) + k]!);
    attributes[`JOINTS_${set}`] = binary.add(vertex.length, { componentType: U16, type: 'VEC4' }, ARRAY);
    for (const v of vertex) for (let k = 0; k < SET; k++) binary.out.f32(weights[first(v) + k]!);
    attributes[`WEIGHTS_${set}`] = binary.add(vertex.length, { componentType: F32, type: 'VEC4' }, ARRAY);
  }
  return attributes;
}

/**
 * Of each joint its place under its parent, and the inverse of where that puts it: nodes cannot be skewed, and whatever a joint loses
 * by that, at rest it moves nothing.
 */
function placesOf({ joints }: Rig, origin: readonly number[]) {
  const local: Pick<GltfNode, 'translation' | 'rotation' | 'scale'>[] = [];
  const world: Affine[] = [];
  for (const start of joints.keys()) {
    // Parents first, in whatever order the joints are.
    const open = [start];
    for (let at = joints[start]!.parent; at >= 0 && !world[at]; at = joints[at]!.parent) open.push(at);
    for (const joint of open.reverse()) {
      if (world[joint]) continue;
      const { parent, bind } = joints[joint]!;
      const wanted = bind.map((x, at) => (at >= 12 && at < 15 ? x - origin[at - 12]! : x));
      const above = world[parent] ?? IDENTITY;
      const place = decompose(multiply(invert(above)!, wanted));
      local[joint] = place;
      world[joint] = multiply(above, compose(place.translation, place.rotation, place.scale));
    }
  }
  return { locals: local, inverses: world.map((matrix) => invert(matrix)!) };
}

/** Translation, rotation and scale of a map, mirrored in x where it mirrors; skew is left out. */
function decompose(m: Affine) {
  const mirror = determinant(m) < 0 ? -1 : 1;
  const scale = [0, 1, 2].map(
    (column) =>
      (column === 0 ? mirror : 1) * Math.hypot(m[4 * column]!, m[4 * column + 1]!, m[4 * column + 2]!),
  );
  const rotation = [...quaternionOf((row, column) => m[4 * column + row]! / scale[column]!)];
  return { translation: m.slice(12, 15), rotation, scale };
}
