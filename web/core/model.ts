// A model as its file gave it. What goes out has the topology that came in: vertex order, polygons,
// colours, texture coordinates, names, unit and up-axis.

import type { Rig } from './rig';

/** One named run of faces: an OBJ group, object or material; a glTF primitive. Face indices, end excluded. */
export interface FaceGroup {
  readonly name: string;
  readonly material?: string;
  readonly start: number;
  readonly end: number;
}

/** A shape beside a model's own, told by how far each vertex goes: a raised brow, an open mouth. */
export interface Morph {
  readonly name: string;
  /** 3 per vertex, as positions are. */
  readonly offsets: Float32Array;
}

export interface Model {
  /** File name without folder, or the built-in's name. */
  readonly name: string;
  /** 3 per vertex, file order and file unit. */
  readonly positions: Float64Array;
  /** Faces + 1 offsets into `faceVertices`. */
  readonly faceOffsets: Uint32Array;
  /** Vertex index per corner. */
  readonly faceVertices: Uint32Array;
  /** RGBA 0–255 per vertex. */
  readonly colors?: Uint8Array;
  /** Whether the file carried alpha. */
  readonly colorAlpha?: boolean;
  /** uv pairs, per vertex (`uvIndices` absent) or looked up per corner through `uvIndices`. */
  readonly uvs?: Float64Array;
  /** Per corner: index into `uvs` / 2; 0xffffffff where the corner has none. */
  readonly uvIndices?: Uint32Array;
  readonly groups?: readonly FaceGroup[];
  /** Vertex sets the file brings along, by name (a head's `scalp`): ascending indices. */
  readonly vertexSets?: Readonly<Record<string, Uint32Array>>;
  /** Shapes that it can take beside its own. */
  readonly morphs?: readonly Morph[];
  /** Joints that move it, and how much of each vertex is whose. */
  readonly rig?: Rig;
  /** What the format said about unit and axis; `undefined` where it says nothing. */
  readonly unitMetres?: number;
  readonly upAxis?: 'y' | 'z';
  /** Whatever else one format must find again on export (glTF node names, transforms, PLY comments …). */
  readonly origin?: { readonly format: ModelFormat; readonly extra: unknown };
}

export type ModelFormat = 'obj' | 'ply' | 'stl' | 'glb' | 'gltf';

export const vertexCount = (model: Model): number => model.positions.length / 3;
export const faceCount = (model: Model): number => Math.max(0, model.faceOffsets.length - 1);

/** The model with its vertices elsewhere, everything else shared. */
export const withPositions = (model: Model, positions: Float64Array): Model => ({ ...model, positions });
