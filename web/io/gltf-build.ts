import { type FaceGroup, type Model, vertexCount } from '../core/model';
import { ByteWriter } from './byte-writer';
import { F32, U8, U16, U32 } from './gltf-accessors';
import type { GltfAccessor, GltfBufferView, GltfJson, GltfNode, GltfPrimitive } from './gltf-schema';
import { groupRuns } from './group-runs';
import { vertexNormals } from './normals';
import { NO_INDEX, nothingToWrite } from './reading';
import { fromSrgb } from './srgb';
import { triangulate } from './triangulate';

export const ARRAY = 34962;
const ELEMENT_ARRAY = 34963;

/** Vertices as glTF wants them, one row for each pair of position and texture coordinate. */
interface Rows {
  /** Model vertex per row; the first rows are the model's vertices in order. */
  readonly vertex: Uint32Array;
  /** Texture coordinate per row. */
  readonly uv: Uint32Array;
  /** Row per triangle corner. */
  readonly corners: Uint32Array;
  /** Face per triangle. */
  readonly faces: Uint32Array;
}

/** What else goes into a document: written to its buffer at once, put into its JSON at the end. Nodes and targets are of one addition. */
export type GltfAddition = (found: {
  readonly binary: BufferBuilder;
  /** Model vertex of each row of the attributes. */
  readonly vertex: Uint32Array;
  /** What positions are told from. */
  readonly origin: readonly number[];
  /** Of the node with the mesh. */
  readonly placement: Placement;
}) => {
  readonly attributes?: Readonly<Record<string, number>>;
  /** In the place of the node with the mesh; those that are not its children are shown beside it. */
  readonly nodes?: (mesh: GltfNode) => { readonly nodes: GltfNode[]; readonly shown: number[] };
  readonly more?: Readonly<Record<string, unknown>>;
  /** Attributes of each morph target, and what the targets are called. */
  readonly targets?: readonly Readonly<Record<string, number>>[];
  readonly targetNames?: readonly string[];
};

/**
 * A document with one node and one mesh, a primitive for each group. The node turns the model's unit and axis into
 * metres with y up, and holds the place of a model far from its origin, which single precision could not.
 */
export function buildGltf(
  model: Model,
  ...additions: readonly (GltfAddition | undefined)[]
): { json: GltfJson; binary: Uint8Array } {
  const rows = splitRows(model);
  if (rows.faces.length === 0) throw nothingToWrite(model, 'glTF');
  const binary = new BufferBuilder(40 * rows.vertex.length + 4 * rows.corners.length);
  const origin = farOrigin(model.positions);
  const place = placement(model, origin);
  const plain = writeAttributes(binary, model, rows, origin);
  const found = { binary, vertex: rows.vertex, origin, placement: place };
  const added = additions.flatMap((addition) => (addition ? [addition(found)] : []));
  const attributes = Object.assign({}, plain, ...added.map((each) => each.attributes));
  const { targets, targetNames } = added.find((each) => each.targets) ?? {};
  const placed = added.find((each) => each.nodes);
  const materials: { name: string }[] = [];
  const primitives: GltfPrimitive[] = [];
  for (const run of groupRuns(model)) {
    const indices = binary.indices(cornersOf(rows, run), rows.vertex.length);
    if (indices === undefined) continue;
    const primitive: GltfPrimitive = { attributes, indices };
    if (targets) primitive.targets = targets.map((target) => ({ ...target }));
    if (run.name) primitive.extras = { name: run.name };
    if (run.material !== undefined) primitive.material = materialIndex(materials, run.material);
    primitives.push(primitive);
  }
  const name = model.name.replace(/\.[^.]*$/, '');
  const node: GltfNode = { name, mesh: 0, ...place };
  const { nodes, shown } = placed?.nodes?.(node) ?? { nodes: [node], shown: [0] };
  const json: GltfJson = {
    asset: { version: '2.0', generator: 'Lissom' },
    scene: 0,
    scenes: [{ nodes: shown }],
    nodes,
    meshes: [{ name, primitives, ...morphs(targetNames) }],
    ...Object.assign({}, ...added.map((each) => each.more)),
    ...(materials.length > 0 && { materials }),
    accessors: binary.accessors,
    bufferViews: binary.views,
  };
  return { json, binary: binary.out.finish() };
}

/** Names of targets are nowhere in the specification; programs look for them here. */
const morphs = (targetNames: readonly string[] | undefined) =>
  targetNames && { weights: targetNames.map(() => 0), extras: { targetNames } };

export class BufferBuilder {
  readonly out: ByteWriter;
  readonly accessors: GltfAccessor[] = [];
  readonly views: GltfBufferView[] = [];

  constructor(expected: number) {
    this.out = new ByteWriter(expected);
  }

  /** @returns the new accessor, or undefined for no indices: an accessor may not be empty */
  indices(values: Uint32Array, rows: number): number | undefined {
    if (values.length === 0) return undefined;
    // The largest index of a type is reserved for restarting strips.
    const wide = rows > 65535;
    for (const value of values) wide ? this.out.u32(value) : this.out.u16(value);
    return this.add(values.length, { componentType: wide ? U32 : U16, type: 'SCALAR' }, ELEMENT_ARRAY);
  }

  /** Describes what was written since the last call. */
  add(
    count: number,
    accessor: Pick<GltfAccessor, 'componentType' | 'type' | 'normalized' | 'min' | 'max'>,
    target?: number,
    byteStride?: number,
  ): number {
    const last = this.views.at(-1);
    const byteOffset = last ? align4(last.byteOffset! + last.byteLength) : 0;
    const byteLength = this.out.length - byteOffset;
    this.out.align(4);
    this.views.push({
      buffer: 0,
      byteOffset,
      byteLength,
      ...(byteStride && { byteStride }),
      ...(target && { target }),
    });
    this.accessors.push({ bufferView: this.views.length - 1, count, ...accessor });
    return this.accessors.length - 1;
  }
}

function writeAttributes(
  binary: BufferBuilder,
  model: Model,
  { vertex, uv }: Rows,
  origin: readonly number[],
): Record<string, number> {
  const { out } = binary;
  const rows = vertex.length;
  const { positions, colors, colorAlpha, uvs } = model;
  const { min, max } = writePositions(out, positions, vertex, origin);
  const attributes: Record<string, number> = {
    POSITION: binary.add(rows, { componentType: F32, type: 'VEC3', min, max }, ARRAY),
  };
  const normals = vertexNormals(model);
  for (const v of vertex) writeNormal(out, normals, v);
  attributes.NORMAL = binary.add(rows, { componentType: F32, type: 'VEC3' }, ARRAY);
  if (uvs) {
    for (const i of uv) {
      out.f32(i === NO_INDEX ? 0 : uvs[2 * i]!);
      out.f32(i === NO_INDEX ? 0 : 1 - uvs[2 * i + 1]!);
    }
    attributes.TEXCOORD_0 = binary.add(rows, { componentType: F32, type: 'VEC2' }, ARRAY);
  }
  if (colors) {
    for (const v of vertex) {
      for (let k = 0; k < 3; k++) out.u16(Math.round(65535 * fromSrgb(colors[4 * v + k]!)));
      out.u16(257 * colors[4 * v + 3]!);
    }
    const type = colorAlpha ? 'VEC4' : 'VEC3';
    attributes.COLOR_0 = binary.add(rows, { componentType: U16, normalized: true, type }, ARRAY, 8);
  }
  for (const [name, set] of Object.entries(model.vertexSets ?? {})) {
    const inside = new Uint8Array(vertexCount(model));
    for (const v of set) inside[v] = 1;
    for (const v of vertex) out.u32(inside[v]!);
    attributes[`_${name}`] = binary.add(rows, { componentType: U8, type: 'SCALAR' }, ARRAY, 4);
  }
  return attributes;
}

/** glTF allows no infinity and no NaN; vertices that have one lie at the origin, without faces. */
export function writePositions(
  out: ByteWriter,
  positions: Float64Array,
  vertex: Iterable<number>,
  origin: readonly number[],
): { min: number[]; max: number[] } {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (const v of vertex)
    for (let k = 0; k < 3; k++) {
      const value = Math.fround(positions[3 * v + k]! - origin[k]!);
      const written = Number.isFinite(value) ? value : 0;
      out.f32(written);
      min[k] = Math.min(min[k]!, written);
      max[k] = Math.max(max[k]!, written);
    }
  return { min, max };
}

/** A normal must have length one, even where there is none. */
export function writeNormal(out: ByteWriter, normals: Float64Array, v: number): void {
  const none = normals[3 * v] === 0 && normals[3 * v + 1] === 0 && normals[3 * v + 2] === 0;
  for (let k = 0; k < 3; k++) out.f32(none && k === 2 ? 1 : normals[3 * v + k]!);
}

function splitRows(model: Model): Rows {
  const { faceVertices, uvs, uvIndices } = model;
  const count = vertexCount(model);
  const { triangles, faces } = triangulate(model);
  const vertex = Array.from({ length: count }, (_, v) => v);
  const uv: number[] = uvs && !uvIndices ? [...vertex] : new Array(count).fill(NO_INDEX);
  const corners = triangles.map((corner) => faceVertices[corner]!);
  if (!uvs || !uvIndices)
    return { vertex: Uint32Array.from(vertex), uv: Uint32Array.from(uv), corners, faces };
  // The first coordinate met at a vertex takes its row, every other a new one at the end.
  const claimed = new Uint8Array(count);
  const others = new Map<number, number>();
  const coordinates = uvs.length / 2 + 1;
  triangles.forEach((corner, i) => {
    const v = faceVertices[corner]!;
    const coordinate = uvIndices[corner]!;
    if (!claimed[v]) {
      claimed[v] = 1;
      uv[v] = coordinate;
    }
    if (uv[v] === coordinate) return;
    const key = v * coordinates + (coordinate === NO_INDEX ? coordinates - 1 : coordinate);
    let row = others.get(key);
    if (row === undefined) {
      row = vertex.push(v) - 1;
      uv.push(coordinate);
      others.set(key, row);
    }
    corners[i] = row;
  });
  return { vertex: Uint32Array.from(vertex), uv: Uint32Array.from(uv), corners, faces };
}

/** Triangles keep the order of their faces, so a run of faces is a run of triangles. */
function cornersOf({ corners, faces }: Rows, { start, end }: FaceGroup): Uint32Array {
  return corners.subarray(3 * lowerBound(faces, start), 3 * lowerBound(faces, end));
}

function lowerBound(sorted: Uint32Array, value: number): number {
  let [low, high] = [0, sorted.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (sorted[middle]! < value) low = middle + 1;
    else high = middle;
  }
  return low;
}

function materialIndex(materials: { name: string }[], name: string): number {
  const known = materials.findIndex((m) => m.name === name);
  return known >= 0 ? known : materials.push({ name }) - 1;
}

/** The middle of a model that lies further from the origin than four times its size, otherwise the origin. */
export function farOrigin(positions: Float64Array): number[] {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i++) {
    const value = positions[i]!;
    if (!Number.isFinite(value)) continue;
    min[i % 3] = Math.min(min[i % 3]!, value);
    max[i % 3] = Math.max(max[i % 3]!, value);
  }
  const middle = min.map((low, k) => (low + max[k]!) / 2);
  const size = Math.hypot(...min.map((low, k) => max[k]! - low));
  return Math.hypot(...middle) > 4 * size ? middle : [0, 0, 0];
}

export type Placement = Pick<GltfNode, 'translation' | 'rotation' | 'scale'>;

function placement({ unitMetres = 1, upAxis = 'y' }: Model, origin: readonly number[]): Placement {
  const [x, y, z] = origin.map((c) => c * unitMetres) as [number, number, number];
  const translation = upAxis === 'z' ? [x, z, -y] : [x, y, z];
  return {
    ...(translation.some((c) => c !== 0) && { translation }),
    ...(upAxis === 'z' && { rotation: [-Math.SQRT1_2, 0, 0, Math.SQRT1_2] }),
    ...(unitMetres !== 1 && { scale: [unitMetres, unitMetres, unitMetres] }),
  };
}

const align4 = (at: number): number => Math.ceil(at / 4) * 4;
