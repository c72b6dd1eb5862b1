// Sharp edges by hand: a click takes an edge as far as it runs, or leaves it; a drag takes a path along edges.

import { nearestOnSegment } from '../../view/overlays/on-segment';
import type { PointerSample, Vec3 } from '../../view/types';
import { type Drag, DragTool } from '../drag-tool';
import { BENT, type EdgeGraph } from '../edge-graph';
import { mix, pointAt } from '../geometry';
import { isHidden } from '../sight';
import { clickSlop, distance } from '../tool';
import type { MatchHost, MatchScene } from './host';

/** CSS pixels within which an edge is pointed at, and within which vertices are looked through for it. */
const REACH = { mouse: 12, pen: 14, touch: 20 } as const;
const AROUND = 60;
/** Vertices looked through at most. */
const MOST = 400;

export type Row = readonly number[];

export class SharpTool extends DragTool {
  constructor(private readonly host: MatchHost) {
    super();
  }

  protected take(sample: PointerSample): Drag | null {
    const scene = this.host.scene();
    if (!scene || sample.button !== 0 || !sample.hit) return null;
    return new Picking(this.host, scene, sample);
  }

  /** What a click would take. */
  override hover(sample: PointerSample): void {
    const scene = this.host.scene();
    const edge = scene && edgeUnder(this.host, scene, sample);
    const line = scene && edge !== null && edge !== undefined ? lineOf(scene, chainAt(scene, edge)) : null;
    this.host.showLine(line);
  }

  override leave(): void {
    this.host.showLine(null);
  }

  override cancel(): void {
    super.cancel();
    this.host.showLine(null);
  }
}

class Picking implements Drag {
  #moved = false;
  #path: number[] | null = null;
  /** The row that is gone on with, its end there last; empty: a new one. */
  readonly #begun: number[];

  constructor(
    private readonly host: MatchHost,
    private readonly scene: MatchScene,
    private readonly first: PointerSample,
  ) {
    this.#begun = first.shift ? begunAt(scene, first.hit!.vertex) : [];
  }

  move(samples: readonly PointerSample[]): void {
    const sample = samples.at(-1);
    if (!sample) return;
    this.#moved ||= distance(this.first, sample) > clickSlop(sample.pointerType);
    if (this.#moved && sample.hit) this.#lead(sample.hit.vertex);
  }

  finish(sample: PointerSample): void {
    this.move([sample]);
    const { host, scene } = this;
    host.showLine(null);
    if (this.#begun.length > 0) {
      if (!this.#moved) this.#lead(this.first.hit!.vertex);
      this.#commit();
    } else if (this.#moved) this.#commit();
    else {
      const edge = edgeUnder(host, scene, this.first);
      if (edge === null) return;
      const picked = rowWith(scene, edge);
      if (picked === null) host.commitSharp(scene.sharp.length, scene.edges().chain(edge));
      else host.commitSharp(picked, []);
    }
  }

  cancel(): void {
    this.host.showLine(null);
  }

  #lead(to: number): void {
    const edges = this.scene.edges();
    const from = this.#begun.at(-1) ?? this.first.hit!.vertex;
    const way = edges.path(from, to, true);
    this.#path = way && (this.#begun.length > 0 ? [...this.#begun, ...way.slice(1)] : way);
    this.host.showLine(this.#path && lineOf(this.scene, this.#path));
  }

  #commit(): void {
    const { host, scene } = this;
    if (!this.#path || this.#path.length < 2) return;
    const row = this.#begun.length > 0 ? scene.sharpRow! : scene.sharp.length;
    host.commitSharp(row, this.#path);
  }
}

/** The selected row, the end that is nearer to a vertex last; none where it is closed. */
function begunAt({ sharp, sharpRow, surface }: MatchScene, vertex: number): number[] {
  const row = sharpRow === null ? undefined : sharp[sharpRow];
  if (!row || row.length < 2 || row[0] === row.at(-1)) return [];
  const at = (v: number) => pointAt(surface.model.positions, v);
  const gapTo = (v: number) => Math.hypot(...at(v).map((x, axis) => x - at(vertex)[axis]!));
  return gapTo(row[0]!) < gapTo(row.at(-1)!) ? [...row].reverse() : [...row];
}

const lineOf = ({ surface }: MatchScene, row: Row): Vec3[] =>
  row.map((v) => pointAt(surface.model.positions, v));

/** What a click on an edge takes, or leaves. */
function chainAt(scene: MatchScene, edge: number): Row {
  const picked = rowWith(scene, edge);
  return picked === null ? scene.edges().chain(edge) : scene.sharp[picked]!;
}

/** The picked row that runs along an edge. */
function rowWith(scene: MatchScene, edge: number): number | null {
  const edges = scene.edges();
  const [a, b] = edges.verticesOf(edge);
  const runs = (row: Row) =>
    row.some((v, i) => {
      const [from, to] = [edges.firstCopy(v), edges.firstCopy(row[i + 1] ?? v)];
      return (from === a && to === b) || (from === b && to === a);
    });
  const at = scene.sharp.findLastIndex(runs);
  return at < 0 ? null : at;
}

/** The edge that is pointed at: a bent one in reach before a smooth one, and of these the nearest that is in sight. */
export function edgeUnder({ view }: MatchHost, scene: MatchScene, sample: PointerSample): number | null {
  if (!sample.hit) return null;
  const { positions } = scene.surface.model;
  const edges = scene.edges();
  const reach = REACH[sample.pointerType];
  const found = [...edgesNear(edges, positions, view, sample)]
    .map((edge) => {
      const [a, b] = edges.verticesOf(edge).map((v) => pointAt(positions, v)) as [Vec3, Vec3];
      return { edge, ...nearestOnSegment(view.project(a), view.project(b), sample.x, sample.y), a, b };
    })
    .filter((each) => each.distance <= reach)
    .sort((one, other) => rank(edges, one.edge) - rank(edges, other.edge) || one.distance - other.distance);
  return found.find(({ a, b, t }) => !isHidden(view, mix(a, b, t)))?.edge ?? null;
}

const rank = (edges: EdgeGraph, edge: number): number => (edges.angleOf(edge) < BENT ? 1 : 0);

function edgesNear(
  edges: EdgeGraph,
  positions: Float64Array,
  view: MatchHost['view'],
  { x, y, hit }: PointerSample,
): Set<number> {
  const found = new Set<number>();
  const seen = new Set([edges.firstCopy(hit!.vertex)]);
  const waiting = [...seen];
  for (let at = 0; at < waiting.length && seen.size < MOST; at++)
    for (const edge of edges.edgesAt(waiting[at]!)) {
      found.add(edge);
      for (const next of edges.verticesOf(edge)) {
        if (seen.has(next)) continue;
        const place = view.project(pointAt(positions, next));
        if (place.behind || Math.hypot(place.x - x, place.y - y) > AROUND) continue;
        seen.add(next);
        waiting.push(next);
      }
    }
  return found;
}
