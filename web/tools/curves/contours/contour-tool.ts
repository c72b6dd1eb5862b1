import type { PenHit, PenPart } from '../../../view/overlays/types';
import type { PointerSample, Vec3 } from '../../../view/types';
import { type Drag, DragTool } from '../../drag-tool';
import { add, dot, gap, norm, scaled, subtract } from '../../geometry';
import { clickSlop, distance } from '../../tool';
import type { ContoursHost, ContoursView } from './host';
import { arcUnder, middleOf, trimmedAt } from './picked';

/** Shares of the model's extent: how far behind the surface a line may be and still be in sight; bounds of a reach. */
const BEHIND = 0.02;
const LEAST_REACH = 0.01;
const MOST_REACH = 1;

/** A click picks a line of the drawing; the one in hand is trimmed by its ends, pulled by itself; the ring is its reach. */
export class ContourTool extends DragTool {
  constructor(private readonly host: ContoursHost) {
    super();
  }

  protected override take(sample: PointerSample): Drag | null {
    if (sample.button !== 0) return null;
    const part = this.host.pen.pickHold(sample.x, sample.y);
    const held = part && this.host.held();
    if (part && held) return this.#dragOf(part, sample);
    const hit = inSight(this.host, sample);
    return hit && new LinePress(this.host, hit, sample);
  }

  override hover({ x, y }: PointerSample): void {
    const part = this.host.pen.pickHold(x, y);
    this.host.hover(part ? null : (inSight(this.host, { x, y })?.line ?? null), part);
  }

  override leave(): void {
    this.host.hover(null, null);
  }

  #dragOf(part: PenPart, sample: PointerSample): Drag {
    switch (part) {
      case 'start':
      case 'end':
        return new TrimDrag(this.host, part);
      case 'ring':
        return new ReachDrag(this.host);
      case 'line':
        return new PullDrag(this.host, sample);
    }
  }
}

/** The nearest line under the pointer that nothing hides. */
export function inSight(
  { pen, view, size }: Pick<ContoursHost, 'pen' | 'view' | 'size'>,
  { x, y }: Pick<PointerSample, 'x' | 'y'>,
): PenHit | null {
  return pen.pickLines(x, y).find(({ point }) => isSeen(view, point, BEHIND * size)) ?? null;
}

/** @param slack  how far the surface may be in front of the point */
function isSeen(view: ContoursView, point: Vec3, slack: number): boolean {
  const { x, y } = view.project(point);
  const met = view.pick(x, y);
  if (!met) return true;
  const { position, target, orthographic } = view.camera;
  const sight = orthographic ? subtract(target, position) : subtract(point, position);
  const away = norm(sight);
  return !(away > 0) || dot(subtract(point, met.point), scaled(sight, 1 / away)) <= slack;
}

/** A press on a line that is not in hand: a click picks it up, a drag picks it up and pulls. */
class LinePress implements Drag {
  #pull: PullDrag | null = null;

  constructor(
    private readonly host: ContoursHost,
    private readonly hit: PenHit,
    private readonly start: PointerSample,
  ) {}

  move(samples: readonly PointerSample[]): void {
    const sample = samples.at(-1);
    if (!sample) return;
    if (!this.#pull && distance(sample, this.start) > clickSlop(sample.pointerType)) {
      this.host.pickUp(this.hit);
      this.#pull = new PullDrag(this.host, this.start);
    }
    this.#pull?.move(samples);
  }

  finish(sample: PointerSample): void {
    if (this.#pull) this.#pull.finish(sample);
    else this.host.pickUp(this.hit);
  }

  cancel(): void {
    this.#pull?.cancel();
  }
}

/** The line goes with the pointer, in the plane of the screen. */
class PullDrag implements Drag {
  readonly #through: Vec3;
  readonly #from: Vec3;
  #moved = false;

  constructor(
    private readonly host: ContoursHost,
    private readonly start: PointerSample,
  ) {
    // At the depth of what is taken hold of: there the line keeps its place under the pointer.
    const away = (point: Vec3): number => {
      const { x, y } = host.view.project(point);
      return Math.hypot(x - start.x, y - start.y);
    };
    const line = host.held()?.line ?? [];
    this.#through = line.reduce<Vec3>(
      (best, point) => (away(point) < away(best) ? point : best),
      line[0] ?? [0, 0, 0],
    );
    this.#from = host.view.pointOnScreenPlane(start.x, start.y, this.#through);
  }

  move(samples: readonly PointerSample[]): void {
    const sample = samples.at(-1);
    if (!sample) return;
    this.#moved ||= distance(sample, this.start) > clickSlop(sample.pointerType);
    if (!this.#moved) return;
    const to = this.host.view.pointOnScreenPlane(sample.x, sample.y, this.#through);
    this.host.pull(subtract(to, this.#from));
  }

  finish(sample: PointerSample): void {
    this.move([sample]);
    if (this.#moved) this.host.release();
  }

  cancel(): void {
    this.host.cancel();
  }
}

/** An end goes along the line. */
class TrimDrag implements Drag {
  constructor(
    private readonly host: ContoursHost,
    private readonly end: 'start' | 'end',
  ) {}

  move(samples: readonly PointerSample[]): void {
    const sample = samples.at(-1);
    const held = this.host.held();
    if (!sample || !held) return;
    const { view, size } = this.host;
    const seen = held.picked.line.map((point) => view.project(add(point, held.shift)));
    const to = arcUnder(held.picked.line, seen, sample.x, sample.y);
    this.host.trim(trimmedAt(held.picked, this.end, to, size));
  }

  finish(): void {
    this.host.settle();
  }

  cancel(): void {
    this.host.cancel();
  }
}

/** The ring goes through the pointer. */
class ReachDrag implements Drag {
  constructor(private readonly host: ContoursHost) {}

  move(samples: readonly PointerSample[]): void {
    const sample = samples.at(-1);
    const held = this.host.held();
    if (!sample || !held) return;
    const { view, size } = this.host;
    const middle = middleOf(held.line);
    const to = view.pointOnScreenPlane(sample.x, sample.y, middle);
    this.host.reach(Math.min(MOST_REACH * size, Math.max(LEAST_REACH * size, gap(to, middle))));
  }

  finish(): void {
    this.host.settle();
  }

  cancel(): void {
    this.host.cancel();
  }
}
