import type { Model } from '../core/model';
import { determinant, invert, transformPoints } from './affine';
import { Budget } from './budget';
import { ByteWriter } from './byte-writer';
import { firstEqualRow } from './equal-rows';
import { F32, readAccessor } from './gltf-accessors';
import { writeNormal, writePositions } from './gltf-build';
import type { GltfExtra, GltfPart } from './gltf-read';
import type { GltfAccessor, GltfBufferView, GltfJson, GltfPrimitive } from './gltf-schema';
import { GrowingUint32 } from './growing';
import { vertexNormals } from './normals';

/**
 * The document a model came from with its vertices where they are now. Parts whose vertices did not move keep every
 * byte; of the others positions and normals are new, and tangents, which viewers can derive, are dropped.
 */
export function rewriteGltf(model: Model, extra: GltfExtra): { json: GltfJson; binary: Uint8Array } {
  const parts = extra.parts.filter((part) => hasMoved(model, extra, part));
  const rewriter = new Rewriter(model, extra, parts);
  for (const part of parts) rewriter.rewrite(part);
  return rewriter.finish();
}

class Rewriter {
  readonly #json: GltfJson;
  /** New bytes by buffer view. */
  readonly #fresh = new Map<number, Uint8Array>();
  readonly #viewUses = new Map<number, number>();
  readonly #accessorUses = new Map<number, number>();
  readonly #budget: Budget;

  constructor(
    readonly model: Model,
    readonly extra: GltfExtra,
    moved: readonly GltfPart[],
  ) {
    const { json, file, size } = extra.document;
    this.#json = structuredClone(json);
    this.#budget = new Budget('gltf', file, size);
    this.#unshareMeshes(moved);
    this.#countUses();
  }

  rewrite(part: GltfPart): void {
    const inverse = invert(part.matrix);
    if (!inverse) return;
    const { first, count } = part;
    const world = this.model.positions.subarray(3 * first, 3 * (first + count));
    const local = transformPoints(inverse, world);
    const mesh = this.#json.meshes![this.#json.nodes![part.node]!.mesh!]!;
    const primitives = part.primitives.map((p) => mesh.primitives[p]!);
    const all = Uint32Array.from({ length: count }, (_, v) => v);

    const positions = new ByteWriter(12 * count);
    const range = writePositions(positions, local, all, [0, 0, 0]);
    const normals = this.#normals(part, local, primitives[0]!.attributes.NORMAL);
    this.#replace(primitives, 'POSITION', positions.finish(), count, range);
    if (normals) {
      const out = new ByteWriter(12 * count);
      for (const v of all) writeNormal(out, normals, v);
      this.#replace(primitives, 'NORMAL', out.finish(), count, {});
    } else for (const primitive of primitives) delete primitive.attributes.NORMAL;
    for (const primitive of primitives) {
      delete primitive.attributes.TANGENT;
      delete primitive.extensions?.KHR_draco_mesh_compression;
    }
  }

  finish(): { json: GltfJson; binary: Uint8Array } {
    const { buffers } = this.extra.document;
    const out = new ByteWriter(buffers.reduce((sum, b) => sum + (b?.length ?? 0), 1024));
    // What is not at hand, pictures in other files, say, keeps its place behind the one buffer that is.
    const elsewhere = [...buffers.keys()].filter((i) => !buffers[i]);
    const views = this.#json.bufferViews ?? [];
    views.forEach((view, i) => {
      const start = view.byteOffset ?? 0;
      const bytes = this.#fresh.get(i) ?? buffers[view.buffer]?.subarray(start, start + view.byteLength);
      if (bytes) {
        out.align(4);
        views[i] = { ...view, buffer: 0, byteOffset: out.length };
        out.raw(bytes);
      } else view.buffer = 1 + elsewhere.indexOf(view.buffer);
    });
    const kept = elsewhere.map((i) => this.#json.buffers![i]!);
    return { json: { ...this.#json, buffers: [{ byteLength: out.length }, ...kept] }, binary: out.finish() };
  }

  /** A mesh that several nodes show is copied for those of them that moved, but for the last one left with it. */
  #unshareMeshes(moved: readonly GltfPart[]): void {
    const nodes = this.#json.nodes!;
    const users = new Map<number, number>();
    for (const { mesh } of nodes) if (mesh !== undefined) users.set(mesh, (users.get(mesh) ?? 0) + 1);
    for (const index of new Set(moved.map((part) => part.node))) {
      const node = nodes[index]!;
      const mesh = node.mesh!;
      if (users.get(mesh)! < 2) continue;
      users.set(mesh, users.get(mesh)! - 1);
      node.mesh = this.#json.meshes!.push(structuredClone(this.#json.meshes![mesh]!)) - 1;
    }
  }

  #countUses(): void {
    const use = (uses: Map<number, number>, index: number | undefined) => {
      if (index !== undefined) uses.set(index, (uses.get(index) ?? 0) + 1);
    };
    for (const { primitives } of this.#json.meshes ?? [])
      for (const { attributes, indices, targets } of primitives) {
        for (const attribute of [attributes, ...(targets ?? [])])
          for (const accessor of Object.values(attribute)) use(this.#accessorUses, accessor);
        use(this.#accessorUses, indices);
      }
    for (const accessor of this.#json.accessors ?? []) use(this.#viewUses, accessor.bufferView);
  }

  /** New values for one attribute: in the old accessor's place where nobody else looks at it, otherwise beside it. */
  #replace(
    primitives: GltfPrimitive[],
    name: string,
    bytes: Uint8Array,
    count: number,
    range: Partial<GltfAccessor>,
  ): void {
    const accessors = this.#json.accessors!;
    const old = primitives[0]!.attributes[name]!;
    const alone = this.#accessorUses.get(old) === primitives.length;
    const { bufferView, sparse } = accessors[old]!;
    const viewAlone = alone && !sparse && bufferView !== undefined && this.#viewUses.get(bufferView) === 1;
    const view: GltfBufferView = { buffer: 0, byteLength: bytes.length, target: 34962 };
    const at = viewAlone ? bufferView : this.#json.bufferViews!.length;
    this.#json.bufferViews![at] = view;
    this.#fresh.set(at, bytes);
    const accessor: GltfAccessor = { bufferView: at, componentType: F32, count, type: 'VEC3', ...range };
    if (alone) accessors[old] = accessor;
    else {
      const index = accessors.push(accessor) - 1;
      this.#accessorUses.set(old, this.#accessorUses.get(old)! - primitives.length);
      for (const primitive of primitives) primitive.attributes[name] = index;
    }
  }

  /** Undefined where the file has none that can be read: a fault there must not stand in the way of an export. */
  #oldNormals(accessor: number | undefined): Float64Array | undefined {
    try {
      return accessor === undefined ? undefined : readAccessor(this.extra.document, accessor, this.#budget);
    } catch {
      return undefined;
    }
  }

  /** Smooth where the file was smooth: vertices that shared position and normal share their new normal. */
  #normals(part: GltfPart, local: Float64Array, accessor: number | undefined): Float64Array | undefined {
    const { first, count, matrix, faces } = part;
    const old = this.#oldNormals(accessor);
    if (old?.length !== 3 * part.count) return undefined;
    const owner = firstEqualRow([this.extra.positions, old], [3 * first, 0], count);
    // A corner that names no vertex stays one.
    const corners = new GrowingUint32();
    for (const [start, end] of faces)
      for (const corner of this.model.faceVertices.subarray(3 * start, 3 * end))
        corners.push(owner[corner - first] ?? count);
    const normals = vertexNormals({
      positions: local,
      faceOffsets: Uint32Array.from({ length: corners.length / 3 + 1 }, (_, f) => 3 * f),
      faceVertices: corners.finish(),
    });
    // The model's faces are turned over where the node mirrors; its own are not.
    const sign = determinant(matrix) < 0 ? -1 : 1;
    return Float64Array.from(
      { length: 3 * count },
      (_, i) => sign * normals[3 * owner[Math.floor(i / 3)]! + (i % 3)]!,
    );
  }
}

function hasMoved({ positions }: Model, extra: GltfExtra, { first, count }: GltfPart): boolean {
  for (let i = 3 * first; i < 3 * (first + count); i++)
    if (!Object.is(positions[i], extra.positions[i])) return true;
  return false;
}
