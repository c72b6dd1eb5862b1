import type { Affine } from '../core/affine';
import { LissomError } from '../core/errors';
import type { FaceGroup, Model } from '../core/model';
import { determinant, transformPoints } from './affine';
import { Budget } from './budget';
import { COMPONENTS, readAccessor, U8 } from './gltf-accessors';
import { entry, type GltfDocument, openGlb, openGltf, refuseCompressed } from './gltf-document';
import { type Influences, RigReader } from './gltf-rig-read';
import { type Placement, readScene, type Scene } from './gltf-scene';
import type { GltfPrimitive } from './gltf-schema';
import { morphsOf, readTargets, type Targets } from './gltf-targets';
import { GrowingUint32 } from './growing';
import { Notes } from './notes';
import { NO_INDEX, type ReadResult } from './reading';
import { toSrgb } from './srgb';

/** One run of the model's vertices: those of a node's primitives that share their attributes. */
export interface GltfPart {
  readonly node: number;
  readonly mesh: number;
  /** Positions in the mesh's list of primitives. */
  readonly primitives: readonly number[];
  readonly first: number;
  readonly count: number;
  /** The model's faces, one run [start, end) per primitive. */
  readonly faces: (readonly [start: number, end: number])[];
  /** From the file's coordinates to the model's. */
  readonly matrix: Affine;
}

/** What a glTF export puts back: the document, and where the model's vertices come from. */
export interface GltfExtra {
  readonly document: GltfDocument;
  readonly parts: readonly GltfPart[];
  readonly positions: Float64Array;
  readonly faceVertices: Uint32Array;
}

interface ReadPart {
  readonly primitives: number[];
  readonly positions: Float64Array;
  readonly uvs: Float64Array | undefined;
  readonly colors: { values: Float64Array; components: number } | undefined;
  readonly sets: ReadonlyMap<string, Float64Array>;
  readonly targets: Targets | null;
  readonly influences: Influences | null;
}

const TRIANGLES = 4;
const FAN = 6;
/** Bytes that a primitive takes each time it is shown, beside its numbers: its run of vertices, its group. */
const SHOWN = 400;
/** Bytes of a coordinate twice more: it is moved to its place, then put with the others. */
const PLACED = 16;
/** Bytes of a vertex at the least: three coordinates, read and placed. */
const VERTEX = 3 * (8 + PLACED);

/**
 * glTF 2.0: all meshes of the scene in one model, in metres and with y up, their nodes' transforms applied. A group
 * is one primitive. Texture coordinates start at the bottom, as in other formats, and colours are sRGB.
 *
 * @param binary  whether the file is a .glb container
 * @throws LissomError `file-not-a-mesh`, `file-incomplete`, `file-truncated`, `file-damaged`, `count-too-large`,
 *                     `format-unsupported`, `file-too-large`, `file-unfolds-too-far`
 */
export function readGltf(bytes: Uint8Array, name: string, binary: boolean): ReadResult {
  const budget = new Budget('gltf', name, bytes.length);
  const document = binary ? openGlb(bytes, name) : openGltf(bytes, name);
  const scene = readScene(document, budget);
  const reader = new GltfReader(document, scene, budget);
  reader.expect(scene.shown);
  for (const placement of scene.shown) reader.read(placement);
  const model = reader.model(name, binary ? 'glb' : 'gltf');
  return { model, notes: reader.notes.list() };
}

class GltfReader {
  readonly notes = new Notes();
  #parts: (GltfPart & ReadPart)[] = [];
  #vertices = 0;
  readonly #faceVertices: GrowingUint32;
  #groups: FaceGroup[] = [];
  readonly #rig: RigReader;

  constructor(
    readonly document: GltfDocument,
    scene: Scene,
    private readonly budget: Budget,
  ) {
    this.#faceVertices = new GrowingUint32(budget);
    this.#rig = new RigReader(document, scene, budget);
  }

  /** Counts the coordinates of all that is shown before the first is read. */
  expect(shown: readonly Placement[]): void {
    const { size, json } = this.document;
    const { accessors, meshes } = json;
    // A count that the file cannot hold is a lie of its own, told as such once it is met.
    const countOf = (accessor: number) => Math.min(accessors?.[accessor]?.count ?? 0, size);
    const costs = new Map<number, number>();
    const costOf = (index: number): number => {
      const { primitives } = entry(this.document, meshes, index, 'mesh');
      const positions = new Set(primitives.map(({ attributes }) => attributes.POSITION));
      let cost = SHOWN * primitives.length;
      for (const at of positions) if (at !== undefined) cost += VERTEX * countOf(at);
      return cost;
    };
    let sum = 0;
    for (const { mesh } of shown) {
      const cost = costs.get(mesh) ?? costOf(mesh);
      costs.set(mesh, cost);
      sum += cost;
    }
    this.budget.expect(sum);
  }

  read(placement: Placement): void {
    const mesh = entry(this.document, this.document.json.meshes, placement.mesh, 'mesh');
    const node = this.document.json.nodes![placement.node]!;
    if (node.skin !== undefined)
      this.notes.add(
        'skin-at-rest',
        'A skinned mesh is shown in the pose it was bound in; its skin is kept.',
      );
    if (node.extensions && 'EXT_mesh_gpu_instancing' in node.extensions)
      this.notes.add('instances-left-out', 'Repeated instances of a mesh are shown once.');
    const local = new Map<string, GltfPart & ReadPart>();
    mesh.primitives.forEach((primitive, index) => {
      this.budget.take(SHOWN);
      const mode = primitive.mode ?? TRIANGLES;
      if (mode < TRIANGLES || mode > FAN || primitive.attributes?.POSITION === undefined) {
        this.notes.add('lines-left-out', 'Lines and single points were left out: only faces are used.');
        return;
      }
      const { attributes, targets } = primitive;
      const key = JSON.stringify([
        Object.entries(attributes)
          .filter(([a]) => isRead(a))
          .sort(),
        targets,
      ]);
      const part = local.get(key) ?? this.#part(placement, primitive, mesh.extras);
      local.set(key, part);
      part.primitives.push(index);
      const start = this.#faceVertices.length / 3;
      this.#faces(primitive, part, mode);
      const end = this.#faceVertices.length / 3;
      part.faces.push([start, end]);
      const name = groupName(primitive) ?? node.name ?? mesh.name ?? `mesh ${placement.mesh}`;
      const material =
        primitive.material === undefined
          ? undefined
          : this.document.json.materials?.[primitive.material]?.name;
      this.#groups.push({ name, ...(material && { material }), start, end });
    });
  }

  model(name: string, format: 'glb' | 'gltf'): Model {
    const faces = this.#faceVertices.length / 3;
    if (faces === 0) {
      const message = `${name} is glTF without a triangle in its scene, so it holds no model. Open another file.`;
      throw new LissomError('file-not-a-mesh', message);
    }
    const positions = new Float64Array(3 * this.#vertices);
    for (const part of this.#parts) positions.set(part.positions, 3 * part.first);
    const faceVertices = this.#faceVertices.finish();
    const parts = this.#parts.map(({ node, mesh, primitives, faces, first, count, matrix }) => ({
      node,
      mesh,
      primitives,
      faces,
      first,
      count,
      matrix,
    }));
    const extra: GltfExtra = { document: this.document, parts, positions, faceVertices };
    return {
      name,
      positions,
      faceOffsets: Uint32Array.from({ length: faces + 1 }, (_, f) => 3 * f),
      faceVertices,
      ...this.#colors(),
      ...this.#uvs(),
      ...this.#sets(),
      ...morphsOf(this.#parts, this.#vertices),
      ...this.#joints(),
      groups: this.#groups,
      unitMetres: 1,
      upAxis: 'y',
      origin: { format, extra },
    };
  }

  /** A skin that cannot be used is told of: the model opens without. */
  #joints(): Pick<Model, 'rig'> {
    const rig = this.#rig.rig(this.#parts, this.#vertices);
    if (this.#rig.fault)
      this.notes.add('skin-unread', `The model opens without its joints. ${this.#rig.fault.message}`);
    return rig;
  }

  #part(placement: Placement, primitive: GltfPrimitive, extras: unknown): GltfPart & ReadPart {
    const { node, mesh, matrix } = placement;
    const { attributes } = primitive;
    const position = entry(this.document, this.document.json.accessors, attributes.POSITION!, 'accessor');
    // A compressed primitive's accessors state only types and counts.
    if (position.bufferView === undefined && !position.sparse)
      refuseCompressed(
        this.document.json.meshes![mesh]!.primitives.flatMap((p) => Object.keys(p.extensions ?? {})),
        this.document.file,
      );
    const local = this.#attribute(attributes.POSITION!, ['VEC3']);
    this.budget.take(PLACED * local.length);
    const positions = transformPoints(matrix, local);
    const count = positions.length / 3;
    const optional = (name: string, types: string[]) => {
      const accessor = attributes[name];
      const fits = accessor !== undefined && this.document.json.accessors?.[accessor]?.count === count;
      return fits ? this.#attribute(accessor, types) : undefined;
    };
    const color = optional('COLOR_0', ['VEC4', 'VEC3']);
    const sets = new Map<string, Float64Array>();
    for (const [name, accessor] of Object.entries(attributes))
      if (name.startsWith('_') && this.#isSet(accessor, count))
        sets.set(name.slice(1), readAccessor(this.document, accessor, this.budget));
    const part = {
      node,
      mesh,
      matrix,
      primitives: [],
      faces: [],
      first: this.#vertices,
      count,
      positions,
      uvs: optional('TEXCOORD_0', ['VEC2']),
      colors: color && { values: color, components: color.length / count },
      sets,
      targets: this.#targets(primitive, { names: namesIn(extras), count, matrix }),
      influences: this.#rig.read(placement, attributes, count),
    };
    this.#parts.push(part);
    this.#vertices += count;
    return part;
  }

  #attribute(index: number, types: readonly string[]): Float64Array {
    const { type } = entry(this.document, this.document.json.accessors, index, 'accessor');
    const values = readAccessor(this.document, index, this.budget);
    if (types.includes(type)) return values;
    const components = COMPONENTS.get(types[0]!)!;
    const count = values.length / COMPONENTS.get(type)!;
    this.budget.take(8 * count * components);
    return new Float64Array(count * components);
  }

  /** Told of, whether they come along or not. */
  #targets(primitive: GltfPrimitive, of: Parameters<typeof readTargets>[2]): Targets | null {
    if (!primitive.targets?.length) return null;
    const read = readTargets(this.document, primitive, of, this.budget);
    if (!read) this.notes.add('morph-targets', 'Morph targets are kept, but not read.');
    return read;
  }

  #isSet(index: number, count: number): boolean {
    const accessor = this.document.json.accessors?.[index];
    return (
      accessor?.count === count &&
      accessor.type === 'SCALAR' &&
      accessor.componentType === U8 &&
      !accessor.normalized
    );
  }

  #faces({ indices }: GltfPrimitive, { first, count, matrix }: GltfPart, mode: number): void {
    const corners = indices === undefined ? undefined : readAccessor(this.document, indices, this.budget);
    const total = corners?.length ?? count;
    const at = (i: number) => {
      const index = corners ? corners[i]! : i;
      return index >= 0 && index < count && Number.isInteger(index) ? first + index : NO_INDEX;
    };
    // A mirroring node turns the faces over (glTF 2.0, section 3.7.4).
    const mirrored = determinant(matrix) < 0;
    const put = (a: number, b: number, c: number) => {
      for (const corner of mirrored ? [a, c, b] : [a, b, c]) this.#faceVertices.push(corner);
    };
    if (mode === TRIANGLES) for (let i = 0; i + 2 < total; i += 3) put(at(i), at(i + 1), at(i + 2));
    else
      for (let i = 2; i < total; i++) {
        const [a, b] =
          mode === FAN ? [at(0), at(i - 1)] : i % 2 === 0 ? [at(i - 2), at(i - 1)] : [at(i - 1), at(i - 2)];
        const c = at(i);
        // Repeated corners only stitch strips together.
        if (a !== b && b !== c && c !== a) put(a, b, c);
      }
  }

  #uvs(): Pick<Model, 'uvs'> {
    if (!this.#parts.some((part) => part.uvs)) return {};
    const uvs = new Float64Array(2 * this.#vertices);
    for (const part of this.#parts)
      part.uvs?.forEach((value, i) => {
        uvs[2 * part.first + i] = i % 2 === 0 ? value : 1 - value;
      });
    return { uvs };
  }

  #colors(): Pick<Model, 'colors' | 'colorAlpha'> {
    if (!this.#parts.some((part) => part.colors)) return {};
    const colors = new Uint8ClampedArray(4 * this.#vertices).fill(255);
    for (const { colors: of, first, count } of this.#parts) {
      if (!of) continue;
      for (let v = 0; v < count; v++)
        for (let k = 0; k < of.components; k++) {
          const value = of.values[of.components * v + k]!;
          colors[4 * (first + v) + k] = k < 3 ? toSrgb(value) : 255 * value;
        }
    }
    return {
      colors: new Uint8Array(colors.buffer),
      colorAlpha: this.#parts.some((part) => part.colors?.components === 4),
    };
  }

  #sets(): Pick<Model, 'vertexSets'> {
    const sets = new Map<string, number[]>();
    for (const { sets: of, first } of this.#parts)
      for (const [name, values] of of) {
        const members = sets.get(name) ?? [];
        sets.set(name, members);
        values.forEach((value, v) => {
          if (value !== 0) members.push(first + v);
        });
      }
    const arrays = [...sets].map(([name, members]) => [name, Uint32Array.from(members)]);
    return arrays.length > 0 ? { vertexSets: Object.fromEntries(arrays) } : {};
  }
}

const groupName = ({ extras }: GltfPrimitive): string | undefined => {
  const name = (extras as { name?: unknown } | null | undefined)?.name;
  return typeof name === 'string' ? name : undefined;
};

const namesIn = (extras: unknown): unknown =>
  (extras as { targetNames?: unknown } | null | undefined)?.targetNames;

const isRead = (attribute: string): boolean =>
  ['POSITION', 'NORMAL', 'TEXCOORD_0', 'COLOR_0'].includes(attribute) ||
  /^(_|(JOINTS|WEIGHTS)_[01]$)/.test(attribute);
