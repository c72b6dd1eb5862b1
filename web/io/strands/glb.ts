import type { Groom } from '../../core/strands';
import { F32, U16, U32 } from '../gltf-accessors';
import { BufferBuilder, buildGltf } from '../gltf-build';
import { packGltf } from '../gltf-container';
import type { GltfJson } from '../gltf-schema';
import { type Cards, makeCards } from './cards';
import { bounds, curvesToWrite } from './curves';
import type { StrandWriteOptions } from './options';
import { headToWrite } from './space';

const ARRAY = 34962;
const ELEMENT_ARRAY = 34963;
/** Vertices are in centimetres; a glTF scene is in metres. */
const SCALE = [0.01, 0.01, 0.01];
/** Share of the screen's height from which each level is drawn. */
const COVERAGE = [0.4, 0.1, 0.01];

/**
 * The hair as cards in three levels of detail (MSFT_lod: programs that do not know it show the finest) and the head
 * as a mesh of its own.
 */
export function writeGlb(groom: Groom, options: StrandWriteOptions): Uint8Array {
  const curves = curvesToWrite(groom, options);
  const head = headToWrite(groom, options);
  const start = head ? buildGltf({ ...head, name: 'Head' }) : undefined;
  const binary = new BufferBuilder(start?.binary.length ?? 65536);
  if (start) {
    binary.out.raw(start.binary);
    binary.accessors.push(...start.json.accessors!);
    binary.views.push(...start.json.bufferViews!);
  }
  const meshes = [...(start?.json.meshes ?? [])];
  const nodes = [...(start?.json.nodes ?? [])];
  const materials = [...(start?.json.materials ?? [])];
  const first = nodes.length;
  const levels = makeCards(curves);
  levels.forEach((cards, lod) => {
    const name = `Hair_LOD${lod}`;
    const primitive = { ...writeCards(binary, cards), material: materials.length };
    meshes.push({ name, primitives: [primitive] });
    nodes.push({
      name,
      mesh: meshes.length - 1,
      scale: SCALE,
      ...(lod === 0 && coarser(first, levels.length - 1)),
    });
  });
  const hair = {
    name: 'Hair',
    doubleSided: true,
    pbrMetallicRoughness: { metallicFactor: 0, roughnessFactor: 0.5 },
  };
  const json: GltfJson = {
    asset: { version: '2.0', generator: 'Lissom' },
    extensionsUsed: ['MSFT_lod'],
    scene: 0,
    scenes: [{ nodes: [...(head ? [0] : []), first] }],
    nodes,
    meshes,
    materials: [...materials, hair],
    accessors: binary.accessors,
    bufferViews: binary.views,
  };
  return packGltf(json, binary.out.finish(), 'glb');
}

/** What names the coarser levels: the nodes after the finest. */
const coarser = (finest: number, count: number) => ({
  extensions: { MSFT_lod: { ids: Array.from({ length: count }, (_, i) => finest + 1 + i) } },
  extras: { MSFT_screencoverage: COVERAGE },
});

function writeCards(binary: BufferBuilder, cards: Cards) {
  const { positions, normals, tangents, uvs, colors } = cards;
  const { out } = binary;
  const vertices = positions.length / 3;
  const floats = (values: Float32Array, type: string, range = {}) => {
    for (const value of values) out.f32(value);
    return binary.add(vertices, { componentType: F32, type, ...range }, ARRAY);
  };
  const attributes: Record<string, number> = {
    POSITION: floats(positions, 'VEC3', bounds(positions)),
    NORMAL: floats(normals, 'VEC3'),
    TANGENT: floats(tangents, 'VEC4'),
    TEXCOORD_0: floats(uvs, 'VEC2'),
  };
  for (let v = 0; v < vertices; v++) {
    for (let k = 0; k < 3; k++) out.u16(Math.round(65535 * colors[3 * v + k]!));
    out.u16(0);
  }
  attributes.COLOR_0 = binary.add(vertices, { componentType: U16, normalized: true, type: 'VEC3' }, ARRAY, 8);
  return { attributes, indices: writeIndices(binary, cards) };
}

/** Two triangles between one row and the next, facing along the normal. */
function writeIndices(binary: BufferBuilder, { count, rows, positions }: Cards): number {
  const wide = positions.length / 3 > 65535;
  const put = (v: number) => (wide ? binary.out.u32(v) : binary.out.u16(v));
  for (let card = 0; card < count; card++)
    for (let r = 0; r < rows - 1; r++) {
      const v = 2 * (rows * card + r);
      for (const corner of [v, v + 1, v + 3, v, v + 3, v + 2]) put(corner);
    }
  const accessor = { componentType: wide ? U32 : U16, type: 'SCALAR' };
  return binary.add(6 * count * (rows - 1), accessor, ELEMENT_ARRAY);
}
