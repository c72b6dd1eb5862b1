import type { PointerSample } from '../view/types';
import { BrushStroke, type PaintHost, type PaintScene, radiusOf } from './brush-stroke';
import type { Tool } from './tool';

export type PaintVerb = 'paint' | 'erase' | 'fill';

/** What one gesture paints: the set it starts from, and where a new set goes. */
interface Canvas {
  readonly base: Uint32Array;
  /** Beside the tint, which every stroke under way has. */
  preview?(vertices: Uint32Array): void;
  commit(verb: PaintVerb, vertices: Uint32Array): void;
}

/** What a brush paints. */
export interface PaintSubject<S extends PaintScene> {
  readonly kind: string;
  /** `null` while there is nothing to paint on. */
  scene(): S | null;
  /** @param first  the vertices under the brush where the gesture begins */
  canvas(scene: S, first: ReadonlySet<number>, erase: boolean): Canvas;
}

/**
 * Paints a vertex set with a round brush on the surface. Alt (or the erase switch) takes away;
 * Shift+click fills up to the painted border, or the whole connected piece.
 */
export class PaintTool<S extends PaintScene> implements Tool {
  #painting: Painting | null = null;

  constructor(
    private readonly host: PaintHost,
    private readonly subject: PaintSubject<S>,
  ) {}

  down(sample: PointerSample): boolean {
    const scene = this.subject.scene();
    if (!scene || sample.button !== 0 || !sample.hit) return false;
    const erase = this.#erases(sample);
    const stroke = new BrushStroke(this.host, scene);
    stroke.extend([sample]);
    const canvas = this.subject.canvas(scene, stroke.touched, erase);
    const base = new Set(canvas.base);
    if (sample.shift) {
      const filled = scene.graph.flood(sample.hit.vertex, (v) => base.has(v) === erase);
      this.#commit('fill', { canvas, base, erase, touched: scene.mirrored(filled) });
      return true;
    }
    this.#painting = { canvas, base, erase, stroke };
    this.#show(sample);
    return true;
  }

  move(samples: readonly PointerSample[]): void {
    const sample = samples.at(-1);
    if (!this.#painting || !sample) return;
    this.#painting.stroke.extend(samples);
    this.#show(sample);
  }

  up(sample: PointerSample): void {
    this.move([sample]);
    const painting = this.#painting;
    this.#painting = null;
    if (!painting) return;
    this.#commit(painting.erase ? 'erase' : 'paint', { ...painting, touched: painting.stroke.touched });
    this.host.showPaint(null);
  }

  hover(sample: PointerSample): void {
    this.#showBrush(sample);
  }

  leave(): void {
    this.host.view.setBrush(null);
  }

  cancel(): void {
    this.#painting = null;
    this.host.showPaint(null);
    this.host.view.setBrush(null);
  }

  #show(sample: PointerSample): void {
    if (!this.#painting) return;
    const { base, erase, stroke, canvas } = this.#painting;
    const vertices = result({ base, erase, touched: stroke.touched });
    this.host.showPaint({ kind: this.subject.kind, vertices });
    canvas.preview?.(vertices);
    this.#showBrush(sample);
  }

  /** Nothing is committed where nothing changes. */
  #commit(verb: PaintVerb, change: Change & { readonly canvas: Canvas }): void {
    const { base, erase, canvas } = change;
    if (![...change.touched].some((v) => base.has(v) === erase)) return;
    canvas.commit(verb, result(change));
  }

  #erases = (sample: PointerSample): boolean => sample.alt !== this.host.brush().erase;

  #showBrush(sample: PointerSample): void {
    const { hit } = sample;
    const radius = hit ? radiusOf(this.host, sample) * this.host.view.pixelSize(hit.point) : 0;
    this.host.view.setBrush(hit ? { hit, radius, erase: this.#erases(sample) } : null);
  }
}

interface Change {
  readonly base: ReadonlySet<number>;
  readonly erase: boolean;
  readonly touched: Iterable<number>;
}

interface Painting {
  readonly canvas: Canvas;
  readonly base: ReadonlySet<number>;
  readonly erase: boolean;
  readonly stroke: BrushStroke;
}

function result({ base, erase, touched }: Change): Uint32Array {
  const out = new Set(base);
  for (const v of touched) {
    if (erase) out.delete(v);
    else out.add(v);
  }
  return Uint32Array.from(out).sort();
}
