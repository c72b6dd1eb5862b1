// What the source of a match has beside its shape, read off it for the skins: they share it, as they share their triangles.

import { type FaceGroup, faceCount, type Model } from '../../../core/model';
import type { SurfacePlaces } from '../../../kernel/contract/wear';
import type { ModelResult } from '../../types';

/** How far from a corner towards the middle of its triangle texture is looked up: on this side of a seam. */
const INWARD = 0.05;
const NO_UV = 0xffffffff;

export type SkinAttributes = Pick<
  Model,
  'colors' | 'colorAlpha' | 'uvs' | 'uvIndices' | 'groups' | 'vertexSets' | 'unitMetres' | 'upAxis'
>;

export interface SkinPlaces {
  /** Of each vertex of the skin. */
  readonly vertices: SurfacePlaces;
  /** Of each corner of its triangles, just inside of them. */
  readonly corners: SurfacePlaces;
  /** Of the middle of each triangle. */
  readonly middles: SurfacePlaces;
}

/** Whether there is anything to be read off. */
export const hasAttributes = ({ colors, uvs, groups, vertexSets, morphs, rig }: Model): boolean =>
  !!(colors || uvs || groups?.length || vertexSets || morphs?.length || rig);

/** Points to ask for: 3 numbers each, in the order of `SkinPlaces`. */
export interface SkinPoints {
  readonly vertices: Float64Array;
  readonly corners: Float64Array;
  readonly middles: Float64Array;
}

/** @param triangles  3 vertices each */
export function askedPoints(positions: Float64Array, triangles: Uint32Array): SkinPoints {
  const corners = new Float64Array(3 * triangles.length);
  const middles = new Float64Array(triangles.length);
  for (let first = 0; first < triangles.length; first += 3)
    for (let axis = 0; axis < 3; axis++) {
      const at = (corner: number) => positions[3 * triangles[first + corner]! + axis]!;
      const middle = (at(0) + at(1) + at(2)) / 3;
      middles[first + axis] = middle;
      for (let corner = 0; corner < 3; corner++)
        corners[3 * (first + corner) + axis] = at(corner) + INWARD * (middle - at(corner));
    }
  return { vertices: positions, corners, middles };
}

/**
 * Colours and vertex sets by the nearest place, mixed by its weights; texture coordinates per corner, so that a seam of the source
 * stays one; groups by the middle of each triangle.
 *
 * @returns the attributes, and in which order the triangles make runs of groups
 */
export function readAttributes(
  { model, opened }: Pick<ModelResult, 'model' | 'opened'>,
  asked: SkinPoints,
  places: SkinPlaces,
): { readonly attributes: SkinAttributes; readonly order: Uint32Array | undefined } {
  const { vertices, middles } = places;
  const { triangles: drawn, faceOfTriangle } = opened;
  const count = vertices.triangles.length;
  const mixed = mixing(drawn, vertices);
  const colors = model.colors && new Uint8Array(4 * count);
  if (colors)
    for (let at = 0; at < colors.length; at++)
      colors[at] = Math.round(mixed(at >> 2, (source) => model.colors![4 * source + (at & 3)]!));
  const vertexSets = model.vertexSets && mapSets(model.vertexSets, count, mixed);
  const order = groupOrder(model, middles, faceOfTriangle);
  const uvs = model.uvs && cornerUvs({ model, opened }, asked, places, order?.order);
  return {
    attributes: {
      ...(colors && { colors }),
      ...(model.colorAlpha !== undefined && { colorAlpha: model.colorAlpha }),
      ...uvs,
      ...(order && { groups: order.groups }),
      ...(vertexSets && { vertexSets }),
      ...(model.unitMetres !== undefined && { unitMetres: model.unitMetres }),
      ...(model.upAxis && { upAxis: model.upAxis }),
    },
    order: order?.order,
  };
}

type Mixed = (vertex: number, value: (source: number) => number) => number;

/** Σ weight · value over the corners of the place of a vertex. */
export const mixing =
  (drawn: Uint32Array, { triangles, weights }: SurfacePlaces): Mixed =>
  (vertex, value) => {
    const first = 3 * triangles[vertex]!;
    let sum = 0;
    for (let corner = 0; corner < 3; corner++)
      sum += weights[3 * vertex + corner]! * value(drawn[first + corner]!);
    return sum;
  };

function mapSets(sets: NonNullable<Model['vertexSets']>, count: number, mixed: Mixed) {
  const found = Object.entries(sets).map(([name, set]) => {
    const members = new Set(set);
    const inside = (vertex: number) => mixed(vertex, (source) => (members.has(source) ? 1 : 0)) >= 0.5;
    return [name, Uint32Array.from(Array.from({ length: count }, (_, v) => v).filter(inside))];
  });
  return Object.fromEntries(found) as Record<string, Uint32Array>;
}

/**
 * Texture coordinates of each corner; equal ones are kept once. A triangle that lies over a seam is all of the piece of texture that its
 * middle is of: its corners beyond the seam continue that.
 */
function cornerUvs(
  { model, opened }: Pick<ModelResult, 'model' | 'opened'>,
  skin: SkinPoints,
  { corners, middles }: SkinPlaces,
  order: Uint32Array | undefined,
): Pick<Model, 'uvs' | 'uvIndices'> {
  const { triangles: drawn, faceOfTriangle } = opened;
  const pieceOf = texturePieces(model);
  const uvs: number[] = [];
  const known = new Map<string, number>();
  const uvIndices = Uint32Array.from({ length: corners.triangles.length }, (_, corner) => {
    const face = order ? order[Math.floor(corner / 3)]! : Math.floor(corner / 3);
    const from = 3 * face + (corner % 3);
    const over =
      pieceOf[faceOfTriangle[corners.triangles[from]!]!] !==
      pieceOf[faceOfTriangle[middles.triangles[face]!]!];
    const triangle = over ? middles.triangles[face]! : corners.triangles[from]!;
    const weights = over
      ? planeWeights(model.positions, drawn, triangle, skin.corners, from)
      : corners.weights.subarray(3 * from, 3 * from + 3);
    let [u, v] = [0, 0];
    for (let at = 0; at < 3; at++) {
      const uv = uvOf(model, faceOfTriangle[triangle]!, drawn[3 * triangle + at]!);
      if (uv === NO_UV) return NO_UV;
      u += weights[at]! * model.uvs![2 * uv]!;
      v += weights[at]! * model.uvs![2 * uv + 1]!;
    }
    const key = `${u},${v}`;
    const index = known.get(key) ?? known.size;
    if (index === known.size) {
      known.set(key, index);
      uvs.push(u, v);
    }
    return index;
  });
  return { uvs: Float64Array.from(uvs), uvIndices };
}

/** Of each face the piece of texture that it is of: those that agree about a vertex they share are of one. */
function texturePieces(model: Model): Int32Array {
  const { faceOffsets, faceVertices, uvs } = model;
  const faces = faceCount(model);
  const parent = Int32Array.from({ length: faces }, (_, face) => face);
  const root = (face: number): number => {
    let at = face;
    while (parent[at] !== at) {
      parent[at] = parent[parent[at]!]!;
      at = parent[at]!;
    }
    return at;
  };
  const first = new Map<string, number>();
  for (let face = 0; face < faces; face++)
    for (let corner = faceOffsets[face]!; corner < faceOffsets[face + 1]!; corner++) {
      const vertex = faceVertices[corner]!;
      const uv = uvOf(model, face, vertex);
      if (uv === NO_UV) continue;
      const key = `${vertex},${uvs![2 * uv]},${uvs![2 * uv + 1]}`;
      const other = first.get(key);
      if (other === undefined) first.set(key, face);
      else parent[root(face)] = root(other);
    }
  return parent.map((_, face) => root(face));
}

/** Weights of a triangle's corners for a point, in the triangle's plane and beyond its sides. */
function planeWeights(
  positions: Float64Array,
  drawn: Uint32Array,
  triangle: number,
  points: Float64Array,
  point: number,
): readonly [number, number, number] {
  const place = (at: number) =>
    positions.subarray(3 * drawn[3 * triangle + at]!, 3 * drawn[3 * triangle + at]! + 3);
  const [a, b, c] = [place(0), place(1), place(2)];
  const p = points.subarray(3 * point, 3 * point + 3);
  const dot = (from: Float64Array, to: Float64Array, other: Float64Array) =>
    [0, 1, 2].reduce((sum, axis) => sum + (to[axis]! - from[axis]!) * (other[axis]! - from[axis]!), 0);
  const [bb, bc, cc] = [dot(a, b, b), dot(a, b, c), dot(a, c, c)];
  const size = bb * cc - bc * bc;
  if (!(size > 0)) return [1, 0, 0];
  const [pb, pc] = [dot(a, p, b), dot(a, p, c)];
  const [v, w] = [(cc * pb - bc * pc) / size, (bb * pc - bc * pb) / size];
  return [1 - v - w, v, w];
}

/** Which texture coordinates a vertex has in a face. */
function uvOf({ uvIndices, faceOffsets, faceVertices }: Model, face: number, vertex: number): number {
  if (!uvIndices) return vertex;
  for (let corner = faceOffsets[face]!; corner < faceOffsets[face + 1]!; corner++)
    if (faceVertices[corner] === vertex) return uvIndices[corner]!;
  return NO_UV;
}

/** Triangles in the order of the source's groups, those of none last, else as they are. */
function groupOrder({ groups, ...model }: Model, { triangles }: SurfacePlaces, faceOfTriangle: Uint32Array) {
  if (!groups?.length) return undefined;
  const groupOfFace = new Int32Array(faceCount({ groups, ...model })).fill(groups.length);
  for (const [at, { start, end }] of groups.entries()) groupOfFace.fill(at, start, end);
  const groupOf = Array.from(triangles, (triangle) => groupOfFace[faceOfTriangle[triangle]!]!);
  const order = Uint32Array.from(groupOf.keys()).sort((a, b) => groupOf[a]! - groupOf[b]! || a - b);
  const runs: FaceGroup[] = [];
  for (let start = 0, end = 0; start < order.length; start = end) {
    const group = groupOf[order[start]!]!;
    while (end < order.length && groupOf[order[end]!] === group) end++;
    if (group < groups.length) runs.push({ ...groups[group]!, start, end });
  }
  return { order, groups: runs };
}
