import { type Affine, IDENTITY, multiply } from '../core/affine';
import { LissomError } from '../core/errors';
import { compose, invert } from './affine';
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
  readonly skin?: number;
}

export interface Scene {
  /** Every mesh of the default scene, in the order of its tree; of all root nodes where there is no scene. */
  readonly shown: readonly Placement[];
  /** Of every node of the scene the one that it hangs from, `undefined` for roots; parents come before their children. */
  readonly parents: ReadonlyMap<number, number | undefined>;
  /** What is wrong with a skin; its mesh stands where its node is. */
  readonly skinFault?: LissomError;
}

export function readScene(doc: GltfDocument, budget: Budget): Scene {
  const nodes = doc.json.nodes ?? [];
  const world = new Map<number, Affine>();
  const parents = new Map<number, number | undefined>();
  // A list of what is to do instead of recursion: trees may be thousands deep. A node met again is passed over.
  const open = roots(doc)
    .map((node) => ({ node, above: undefined as number | undefined }))
    .reverse();
  for (let next = open.pop(); next; next = open.pop()) {
    if (world.has(next.node)) continue;
    const node = entry(doc, nodes, next.node, 'node');
    const matrix = multiply(next.above === undefined ? IDENTITY : world.get(next.above)!, localMatrix(node));
    if (!matrix.every(Number.isFinite))
      throw gltfDamaged(doc.file, `node ${next.node} is moved or scaled beyond what numbers can hold`);
    world.set(next.node, matrix);
    parents.set(next.node, next.above);
    for (const child of [...(node.children ?? [])].reverse()) open.push({ node: child, above: next.node });
  }
  let skinFault: LissomError | undefined;
  const bound = new Map<number, Affine | undefined>();
  const boundBy = (skin: number): Affine | undefined => {
    if (bound.has(skin)) return bound.get(skin);
    let matrix: Affine | undefined;
    try {
      matrix = bindMatrix(doc, skin, world, budget);
    } catch (error) {
      skinFault ??= unlessRefused(error);
    }
    bound.set(skin, matrix);
    return matrix;
  };
  const shown = [...parents.keys()].flatMap((index): Placement[] => {
    const { mesh, skin } = nodes[index]!;
    if (mesh === undefined) return [];
    const matrix = (skin === undefined ? undefined : boundBy(skin)) ?? world.get(index)!;
    return [{ node: index, mesh, matrix, ...(skin !== undefined && { skin }) }];
  });
  return { shown, parents, ...(skinFault && { skinFault }) };
}

/** A fault that can be lived with; a file that unfolds too far is refused whatever it was in. */
export function unlessRefused(error: unknown): LissomError {
  if (error instanceof LissomError && error.code !== 'file-unfolds-too-far') return error;
  throw error;
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
  const matrix = inverse.length === 16 ? multiply(joint, inverse) : [];
  if (matrix.length === 0 || !matrix.every(Number.isFinite) || !invert(matrix))
    throw gltfDamaged(doc.file, `skin ${index} is bound by a matrix that leads nowhere`);
  return matrix;
}
