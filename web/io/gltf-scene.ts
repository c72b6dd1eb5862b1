import { type Affine, IDENTITY } from '../core/affine';
import { compose, multiply } from './affine';
import type { Budget } from './budget';
import { readAccessor } from './gltf-accessors';
import { entry, type GltfDocument, gltfDamaged } from './gltf-document';
import type { GltfNode } from './gltf-schema';

/** A mesh where a node of the scene puts it. */
export interface Placement {
  readonly node: number;
  readonly mesh: number;
  /** From the mesh's coordinates to the scene's. */
  readonly matrix: Affine;
}

/** Every mesh of the default scene, in the order of its tree; of all root nodes where there is no scene. */
export function placements(doc: GltfDocument, budget: Budget): Placement[] {
  const nodes = doc.json.nodes ?? [];
  const world = new Map<number, Affine>();
  const order: number[] = [];
  // A list of what is to do instead of recursion: trees may be thousands deep. A node met again is passed over.
  const open = roots(doc)
    .map((node) => ({ node, parent: IDENTITY }))
    .reverse();
  for (let next = open.pop(); next; next = open.pop()) {
    if (world.has(next.node)) continue;
    const node = entry(doc, nodes, next.node, 'node');
    const matrix = multiply(next.parent, localMatrix(node));
    if (!matrix.every(Number.isFinite))
      throw gltfDamaged(doc.file, `node ${next.node} is moved or scaled beyond what numbers can hold`);
    world.set(next.node, matrix);
    order.push(next.node);
    for (const child of [...(node.children ?? [])].reverse()) open.push({ node: child, parent: matrix });
  }
  return order.flatMap((index) => {
    const { mesh, skin } = nodes[index]!;
    if (mesh === undefined) return [];
    return [
      {
        node: index,
        mesh,
        matrix: skin === undefined ? world.get(index)! : bindMatrix(doc, skin, world, budget),
      },
    ];
  });
}

function roots({ json }: GltfDocument): readonly number[] {
  const scene = json.scenes?.[json.scene ?? 0];
  if (scene) return scene.nodes ?? [];
  const children = new Set((json.nodes ?? []).flatMap((node) => node.children ?? []));
  return [...(json.nodes ?? []).keys()].filter((node) => !children.has(node));
}

function localMatrix({ matrix, translation, rotation, scale }: GltfNode): Affine {
  return matrix ?? compose(translation ?? [0, 0, 0], rotation ?? [0, 0, 0, 1], scale ?? [1, 1, 1]);
}

/** Skinned vertices ignore their node; in the pose they were bound in, every joint moves them alike. */
function bindMatrix(
  doc: GltfDocument,
  index: number,
  world: ReadonlyMap<number, Affine>,
  budget: Budget,
): Affine {
  const { joints, inverseBindMatrices } = entry(doc, doc.json.skins, index, 'skin');
  const joint = world.get(joints[0]!) ?? IDENTITY;
  if (inverseBindMatrices === undefined) return joint;
  const inverse = [...readAccessor(doc, inverseBindMatrices, budget).subarray(0, 16)];
  return inverse.length === 16 ? multiply(joint, inverse) : joint;
}
