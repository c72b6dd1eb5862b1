// What can be told from a roughly painted region: its edge, the feature in its middle, the openings in it.

import type { MeshGraph } from '../mesh-graph';
import { NearestFirst } from '../nearest-first';
import type { Loop } from './loops';

/** The feature is what lies farther inside the region than this part of its depth. */
const RING = 0.4;

/**
 * The feature of a region in which none is painted (Fu 3.4.1): its middle, with all that the ring around it does
 * not reach. The ring takes 40 % of the region's depth, by edge lengths.
 *
 * @param positions  3 per file vertex
 * @returns empty where the region has no edge, or is too narrow to have a middle
 */
export function featureWithin(graph: MeshGraph, region: Uint32Array, positions: Float64Array): Uint32Array {
  const inside = new Set(region);
  const depth = depthsWithin(graph, region, inside, positions);
  let [deepest, most] = [-1, 0];
  for (const [vertex, distance] of depth) if (distance > most) [deepest, most] = [vertex, distance];
  if (deepest < 0) return new Uint32Array();
  const core = new Set(graph.flood(deepest, (v) => inside.has(v) && (depth.get(v) ?? 0) > RING * most));
  const ring = new Set<number>();
  for (const [vertex, distance] of depth)
    if (distance === 0 && !ring.has(vertex))
      for (const v of graph.flood(vertex, (each) => inside.has(each) && !core.has(each))) ring.add(v);
  return region.filter((v) => !ring.has(v));
}

/**
 * A rough mark made into one patch: its largest piece, with the holes in it filled. Only the largest piece of what
 * is not marked stays outside.
 */
export function tidied(graph: MeshGraph, mark: Uint32Array, count: number): Uint32Array {
  const marked = new Set(mark);
  const patch = new Set(largest(graph, mark, (v) => marked.has(v)));
  const rest = Array.from({ length: count }, (_, v) => v).filter((v) => !patch.has(v));
  const outside = new Set(largest(graph, rest, (v) => !patch.has(v)));
  // A piece of another part of the model is no hole: only what touches the patch can be one.
  const holes = new Set<number>();
  for (const v of patch)
    for (const near of graph.neighbours(v))
      if (!patch.has(near) && !outside.has(near) && !holes.has(near))
        for (const each of graph.flood(near, (w) => !patch.has(w))) holes.add(each);
  return graph.withCopies([...patch, ...holes]);
}

function largest(
  graph: MeshGraph,
  among: Iterable<number>,
  passable: (vertex: number) => boolean,
): Uint32Array {
  const seen = new Set<number>();
  let best: Uint32Array = new Uint32Array();
  for (const vertex of among) {
    if (seen.has(vertex)) continue;
    const piece = graph.flood(vertex, passable);
    for (const v of piece) seen.add(v);
    if (piece.length > best.length) best = piece;
  }
  return best;
}

/** Distance of each vertex from the region's edge along its mesh edges (Dijkstra 1959). */
function depthsWithin(
  graph: MeshGraph,
  region: Uint32Array,
  inside: ReadonlySet<number>,
  positions: Float64Array,
): Map<number, number> {
  const depth = new Map<number, number>();
  const waiting = new NearestFirst();
  for (const vertex of region)
    if (graph.neighbours(vertex).some((near) => !inside.has(near))) waiting.push(vertex, 0);
  for (let next = waiting.pop(); next; next = waiting.pop()) {
    const [vertex, distance] = next;
    if (depth.has(vertex)) continue;
    for (const copy of graph.withCopies([vertex])) depth.set(copy, distance);
    for (const near of graph.neighbours(vertex))
      if (inside.has(near) && !depth.has(near)) waiting.push(near, distance + apart(positions, vertex, near));
  }
  return depth;
}

const apart = (x: Float64Array, a: number, b: number): number =>
  Math.hypot(x[3 * a]! - x[3 * b]!, x[3 * a + 1]! - x[3 * b + 1]!, x[3 * a + 2]! - x[3 * b + 2]!);

/** The openings that a mark touches, longest first. */
export function loopsTouched(loops: readonly Loop[], mark: Uint32Array): Loop[] {
  const marked = new Set(mark);
  return loops.filter((loop) => loop.some((vertex) => marked.has(vertex)));
}
