// What tests measure of grown hair by plain geometry, without the kernel's distance grid.

import { BufferAttribute, BufferGeometry, DoubleSide, Ray, Vector3 } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import type { Model } from '../../web/core/model';
import type { Strands } from '../../web/core/strands';

export type Vec = readonly [number, number, number];

const minus = (a: Vec, b: Vec): Vec => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Vec, b: Vec): Vec => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const along = (a: Vec, t: number, by: Vec): Vec => [a[0] + t * by[0], a[1] + t * by[1], a[2] + t * by[2]];
const length = (a: Vec): number => Math.hypot(...a);

/** Model space. */
export function strandPoint({ points, origin }: Strands, at: number): Vec {
  return [points[3 * at]! + origin[0], points[3 * at + 1]! + origin[1], points[3 * at + 2]! + origin[2]];
}

export const heightOf = ({ positions }: Model): number => {
  const ys = positions.filter((_, i) => i % 3 === 1);
  return ys.reduce((a, b) => Math.max(a, b)) - ys.reduce((a, b) => Math.min(a, b));
};

type Triangle = readonly [Vec, Vec, Vec];

export function trianglesOf({ positions, faceOffsets, faceVertices }: Model): Triangle[] {
  const at = (v: number): Vec => [positions[3 * v]!, positions[3 * v + 1]!, positions[3 * v + 2]!];
  const triangles: Triangle[] = [];
  for (let f = 0; f + 1 < faceOffsets.length; f++) {
    const corners = [...faceVertices.subarray(faceOffsets[f]!, faceOffsets[f + 1]!)].map(at);
    for (let i = 2; i < corners.length; i++) triangles.push([corners[0]!, corners[i - 1]!, corners[i]!]);
  }
  return triangles;
}

/** A triangle more on every edge that has one only, to the middle of all such edges that hang together. */
function closed(triangles: readonly Triangle[]): Triangle[] {
  const open = new Map<string, [Vec, Vec]>();
  for (const triangle of triangles)
    for (const [k, a] of triangle.entries()) {
      const b = triangle[(k + 1) % 3]!;
      if (!open.delete(`${b}>${a}`)) open.set(`${a}>${b}`, [a, b]);
    }
  const next = new Map([...open.values()].map(([a, b]) => [String(a), b]));
  const caps: Triangle[] = [];
  while (next.size > 0) {
    const loop: Vec[] = [];
    for (let at = next.keys().next().value!; next.has(at); at = String(loop.at(-1))) {
      loop.push(next.get(at)!);
      next.delete(at);
    }
    const middle = [0, 1, 2].map(
      (d) => loop.reduce((sum, p) => sum + p[d]!, 0) / loop.length,
    ) as unknown as Vec;
    for (const [k, b] of loop.entries()) caps.push([b, loop.at(k - 1)!, middle]);
  }
  return [...triangles, ...caps];
}

/** No side of a head, so that a ray runs along no edge of it. */
const SOMEWHERE = new Vector3(0.31, 0.87, -0.38).normalize();

/**
 * How deep the deepest point of all strands lies inside, 0 where none does; depths up to `shallow` are not told apart.
 * Every point is asked how far the surface is, its openings closed. It is inside where a ray leaves the surface once
 * more often than it enters.
 */
export function deepestInside(strands: Strands, triangles: readonly Triangle[], shallow: number): number {
  const surface = closed(triangles);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(Float64Array.from(surface.flat(2)), 3));
  const tree = new MeshBVH(geometry, { indirect: true });
  const ray = new Ray(new Vector3(), SOMEWHERE);
  const leaving = (face: number): number => {
    const [p, q, r] = surface[face]!;
    return Math.sign(dot(cross(minus(q, p), minus(r, p)), SOMEWHERE.toArray()));
  };
  let deepest = 0;
  for (let at = 0; at < strands.points.length / 3; at++) {
    ray.origin.set(...strandPoint(strands, at));
    // Beyond its limit the tree may still answer, with what it came across.
    const near = tree.closestPointToPoint(ray.origin, undefined, shallow, shallow);
    if (near && near.distance <= shallow) continue;
    const out = tree.raycast(ray, DoubleSide).reduce((sum, hit) => sum + leaving(hit.faceIndex!), 0);
    if (out > 0) deepest = Math.max(deepest, tree.closestPointToPoint(ray.origin)!.distance);
  }
  return deepest;
}

/** On which side of a parting a point lies: its distance from the plane there, `null` beyond the line's ends. */
function sideOf(point: Vec, line: readonly Vec[], normals: readonly Vec[]): number | null {
  let best = { square: Infinity, side: null as number | null };
  for (let i = 0; i + 1 < line.length; i++) {
    const [p, by] = [line[i]!, minus(line[i + 1]!, line[i]!)];
    const t = dot(minus(point, p), by) / dot(by, by);
    const beyond = (i === 0 && t < 0) || (i + 2 === line.length && t > 1);
    const held = Math.min(1, Math.max(0, t));
    const from = minus(point, along(p, held, by));
    const square = dot(from, from);
    if (square >= best.square) continue;
    const normal = along(normals[i]!, held, minus(normals[i + 1]!, normals[i]!));
    const across = cross(by, normal);
    best = { square, side: beyond ? null : dot(from, across) / length(across) };
  }
  return best.side;
}

/** Unit normal of the skin nearest to a point: of the nearest triangle that faces anywhere. */
export function skinNormal(point: Vec, triangles: readonly Triangle[]): Vec {
  let best = Infinity;
  let normal: Vec = [0, 1, 0];
  for (const [p, q, r] of triangles) {
    const middle: Vec = [0, 1, 2].map((k) => (p[k]! + q[k]! + r[k]!) / 3) as unknown as Vec;
    const away = length(minus(middle, point));
    const area = cross(minus(q, p), minus(r, p));
    if (away >= best || length(area) === 0) continue;
    best = away;
    normal = along([0, 0, 0], 1 / length(area), area);
  }
  return normal;
}

export interface Crossings {
  /** Strands rooted beside the line, no farther than `reach` from it. */
  readonly near: number;
  /** Of these, those that come to lie on the other side within `first` of their root, and how far the worst does. */
  readonly crossing: number;
  readonly worst: number;
}

export function partingCrossings(
  strands: Strands,
  line: readonly Vec[],
  triangles: readonly Triangle[],
  { reach, first }: { readonly reach: number; readonly first: number },
): Crossings {
  const normals = line.map((point) => skinNormal(point, triangles));
  let [near, crossing, worst] = [0, 0, 0];
  for (let s = 0; s + 1 < strands.offsets.length; s++) {
    const [start, end] = [strands.offsets[s]!, strands.offsets[s + 1]!];
    let last = strandPoint(strands, start);
    const root = sideOf(last, line, normals);
    if (root === null || Math.abs(root) > reach) continue;
    near++;
    let over = 0;
    for (let at = start + 1, arc = 0; at < end; at++) {
      const point = strandPoint(strands, at);
      arc += length(minus(point, last));
      if (arc > first) break;
      last = point;
      const side = sideOf(point, line, normals);
      if (side !== null && side * root < 0) over = Math.max(over, Math.abs(side));
    }
    if (over > 0) crossing++;
    worst = Math.max(worst, over);
  }
  return { near, crossing, worst };
}
