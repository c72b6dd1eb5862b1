import type { Affine } from '../core/affine';
import type { Model, Morph } from '../core/model';
import { transformPoints } from './affine';
import type { Budget } from './budget';
import { readAccessor } from './gltf-accessors';
import type { GltfDocument } from './gltf-document';
import type { GltfPrimitive } from './gltf-schema';

/** The morph targets of a run of vertices: what each is called, and how far it takes them. */
export type Targets = ReadonlyMap<string, Float64Array>;

/** Bytes of a number: as it is read, as it is turned, as the model keeps it. */
const NUMBER = 8 + 8 + 4;

/**
 * Morph targets of a primitive (Khronos glTF 2.0 specification, 3.7.2.2), turned and scaled as its node is.
 *
 * @param names  of the targets, as far as the mesh tells any
 * @returns `null` where they move nothing, are not of its vertices, or would unfold too far
 */
export function readTargets(
  document: GltfDocument,
  { targets = [] }: GltfPrimitive,
  { names, count, matrix }: { readonly names: unknown; readonly count: number; readonly matrix: Affine },
  budget: Budget,
): Targets | null {
  const { accessors } = document.json;
  const moved = targets.flatMap(({ POSITION }, at) => (POSITION === undefined ? [] : [{ POSITION, at }]));
  const fits = moved.every(({ POSITION }) => {
    const accessor = accessors?.[POSITION];
    return accessor?.count === count && accessor.type === 'VEC3';
  });
  if (moved.length === 0 || !fits || !budget.holds(3 * count * NUMBER * moved.length)) return null;
  const linear = matrix.map((x, at) => (at > 11 && at < 15 ? 0 : x));
  const read = new Map<string, Float64Array>();
  for (const { POSITION, at } of moved) {
    const offsets = transformPoints(linear, readAccessor(document, POSITION, budget));
    budget.take(3 * count * (NUMBER - 8));
    read.set(freeName(read, nameAt(names, at)), offsets);
  }
  return read;
}

/** Those of all runs, by name. */
export function morphsOf(
  parts: readonly { readonly first: number; readonly targets: Targets | null }[],
  vertices: number,
): Pick<Model, 'morphs'> {
  const found = new Map<string, Float32Array>();
  for (const { first, targets } of parts)
    for (const [name, offsets] of targets ?? []) {
      const held = found.get(name) ?? new Float32Array(3 * vertices);
      held.set(offsets, 3 * first);
      found.set(name, held);
    }
  const morphs = [...found].map(([name, offsets]): Morph => ({ name, offsets }));
  return morphs.length > 0 ? { morphs } : {};
}

/** The specification has no place for names; programs write them to the mesh's extras. */
function nameAt(names: unknown, at: number): string {
  const name: unknown = Array.isArray(names) ? names[at] : undefined;
  return typeof name === 'string' && name !== '' ? name : `morph ${at + 1}`;
}

function freeName(taken: ReadonlyMap<string, unknown>, wanted: string): string {
  let name = wanted;
  for (let n = 2; taken.has(name); n++) name = `${wanted} ${n}`;
  return name;
}
