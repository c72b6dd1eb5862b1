// The merged model put together from its two files and what the kernel says of them: polygons, colours, texture
// coordinates, groups and vertex sets are carried along.

import type { FaceGroup, Model } from '../../../core/model';
import type { MergeContribution, Merged, Origins } from '../../../kernel/contract/merge';

/** One of the two files and its share. */
interface Side {
  readonly model: Model;
  readonly share: MergeContribution;
  readonly isSource: boolean;
}

const NO_UV = 0xffffffff;

export function mergedModel(target: Model, source: Model, merged: Merged): Model {
  const sides: readonly Side[] = [
    { model: target, share: merged.target, isSource: false },
    { model: source, share: merged.source, isSource: true },
  ];
  const faces = mergeFaces(sides, merged);
  const { unitMetres, upAxis, origin } = target;
  return {
    name: target.name,
    positions: merged.positions,
    faceOffsets: faces.offsets,
    faceVertices: faces.vertices,
    ...colorsOf(sides, merged),
    ...uvsOf(sides, merged, faces),
    ...groupsOf(sides, merged),
    ...vertexSetsOf(sides),
    ...(unitMetres === undefined ? {} : { unitMetres }),
    ...(upAxis === undefined ? {} : { upAxis }),
    ...(origin === undefined ? {} : { origin }),
  };
}

interface Faces {
  readonly offsets: Uint32Array;
  readonly vertices: Uint32Array;
  /** Corner in its file of each corner of the whole faces; the cut triangles come after them. */
  readonly corners: Uint32Array;
  /** The first of the source's corners. */
  readonly sourceStart: number;
}

function mergeFaces(sides: readonly Side[], { cutVertices }: Merged): Faces {
  const offsets = [0];
  const vertices: number[] = [];
  const corners: number[] = [];
  let sourceStart = 0;
  for (const { model, share, isSource } of sides) {
    if (isSource) sourceStart = corners.length;
    for (const [at, face] of share.faces.entries()) {
      const start = model.faceOffsets[face]!;
      const end = model.faceOffsets[face + 1]!;
      for (let k = start; k < end; k++) {
        const corner = share.turned[at] ? start + end - 1 - k : k;
        corners.push(corner);
        vertices.push(share.resultOfVertex[model.faceVertices[corner]!]!);
      }
      offsets.push(vertices.length);
    }
  }
  for (let k = 0; k < cutVertices.length; k++) {
    vertices.push(cutVertices[k]!);
    if (k % 3 === 2) offsets.push(vertices.length);
  }
  return {
    offsets: Uint32Array.from(offsets),
    vertices: Uint32Array.from(vertices),
    corners: Uint32Array.from(corners),
    sourceStart,
  };
}

/** A side without colours is white beside one that has some. */
function colorsOf(sides: readonly Side[], merged: Merged): Pick<Model, 'colors' | 'colorAlpha'> {
  if (!sides.some(({ model }) => model.colors)) return {};
  const colors = new Uint8Array((4 * merged.positions.length) / 3).fill(255);
  // The target last: a vertex that both share is the target's.
  for (const { model, share } of sides.toReversed())
    if (model.colors)
      for (const [vertex, at] of share.resultOfVertex.entries())
        if (at >= 0) colors.set(model.colors.subarray(4 * vertex, 4 * vertex + 4), 4 * at);
  const first = merged.positions.length / 3 - merged.newFromSource.length;
  for (const [k, fromSource] of merged.newFromSource.entries()) {
    const { model } = sides[fromSource]!;
    if (model.colors) colors.set(mixed(model.colors, 4, merged.newOrigins, k), 4 * (first + k));
  }
  return { colors, colorAlpha: sides.some(({ model }) => model.colorAlpha) };
}

/** Values of an origin's three vertices, weighted. */
function mixed(values: Uint8Array | Float64Array, width: number, { vertices, weights }: Origins, at: number) {
  const sum = new Array<number>(width).fill(0);
  for (let k = 3 * at; k < 3 * at + 3; k++)
    for (let c = 0; c < width; c++) sum[c]! += weights[k]! * values[width * vertices[k]! + c]!;
  return values instanceof Uint8Array ? sum.map(Math.round) : sum;
}

/** Per corner, since the two sides of a seam seldom agree. */
function uvsOf(sides: readonly Side[], merged: Merged, faces: Faces): Pick<Model, 'uvs' | 'uvIndices'> {
  if (!sides.some(({ model }) => model.uvs)) return {};
  const uvs: number[] = [];
  const uvIndices = new Uint32Array(faces.vertices.length).fill(NO_UV);
  const starts = sides.map(({ model }) => {
    const start = uvs.length / 2;
    for (const coordinate of model.uvs ?? []) uvs.push(coordinate);
    return start;
  });
  for (const [k, corner] of faces.corners.entries()) {
    const from = k < faces.sourceStart ? 0 : 1;
    const at = uvOfCorner(sides[from]!.model, corner);
    if (at !== NO_UV) uvIndices[k] = starts[from]! + at;
  }
  for (const [triangle, face] of merged.cutFaces.entries()) {
    const { model } = sides[merged.cutFromSource[triangle]!]!;
    if (!model.uvs) continue;
    for (let c = 3 * triangle; c < 3 * triangle + 3; c++) {
      const uv = uvOfOrigin(model, face, merged.cutOrigins, c);
      if (!uv) continue;
      uvIndices[faces.corners.length + c] = uvs.length / 2;
      uvs.push(...uv);
    }
  }
  return { uvs: Float64Array.from(uvs), uvIndices };
}

function uvOfCorner(model: Model, corner: number): number {
  if (!model.uvs) return NO_UV;
  return model.uvIndices ? model.uvIndices[corner]! : model.faceVertices[corner]!;
}

function uvOfOrigin(model: Model, face: number, { vertices, weights }: Origins, at: number) {
  let u = 0;
  let v = 0;
  for (let k = 3 * at; k < 3 * at + 3; k++) {
    if (weights[k] === 0) continue;
    const end = model.faceOffsets[face + 1]!;
    let corner = model.faceOffsets[face]!;
    while (corner < end && model.faceVertices[corner] !== vertices[k]) corner++;
    // A triangle of the band around an optimal boundary lies on several polygons.
    const index = uvOfCorner(model, corner < end ? corner : model.faceVertices.indexOf(vertices[k]!));
    if (index === NO_UV) return undefined;
    u += weights[k]! * model.uvs![2 * index]!;
    v += weights[k]! * model.uvs![2 * index + 1]!;
  }
  return [u, v] as const;
}

/** The groups of both files, as far as their whole faces go; cut triangles join none. */
function groupsOf(sides: readonly Side[], merged: Merged): Pick<Model, 'groups'> {
  if (!sides.some(({ model }) => model.groups)) return {};
  const groups: FaceGroup[] = [];
  let first = 0;
  for (const { model, share } of sides) {
    for (const { start, end, ...rest } of model.groups ?? [{ name: model.name, start: 0, end: Infinity }]) {
      const from = first + share.faces.findIndex((face) => face >= start);
      const count = share.faces.reduce((sum, face) => sum + Number(face >= start && face < end), 0);
      if (count > 0) groups.push({ ...rest, start: from, end: from + count });
    }
    first += share.faces.length;
  }
  if (merged.cutFaces.length > 0)
    groups.push({ name: 'seam', start: first, end: first + merged.cutFaces.length });
  return { groups };
}

function vertexSetsOf(sides: readonly Side[]): Pick<Model, 'vertexSets'> {
  const sets: Record<string, Uint32Array> = {};
  for (const { model, share } of sides)
    for (const [name, set] of Object.entries(model.vertexSets ?? {})) {
      const kept = [...set].map((vertex) => share.resultOfVertex[vertex]!).filter((at) => at >= 0);
      if (kept.length > 0) sets[name] = Uint32Array.from(new Set([...(sets[name] ?? []), ...kept])).sort();
    }
  return Object.keys(sets).length > 0 ? { vertexSets: sets } : {};
}
