import { toIndices } from '../../core/vertex-set';
import type { PointerSample } from '../../view/types';
import type { Tool } from '../tool';
import { recipeSet, setHandleVertices } from './edits';
import type { DeformEdit, DeformHost, DeformScene, EditLabel } from './host';
import { radiusOf, Stroke } from './stroke';

/** What one gesture paints: the set it starts from, and the edit a new set makes. */
interface Canvas {
  readonly base: Uint32Array;
  edit(vertices: Uint32Array): DeformEdit;
}

interface Subject {
  readonly kind: 'roi' | 'handle';
  /** @param first  the vertices under the brush where the gesture begins */
  canvas(scene: DeformScene, first: ReadonlySet<number>, erase: boolean): Canvas;
}

/**
 * Paints a vertex set with a round brush on the surface. Alt (or the erase switch) takes away;
 * Shift+click fills up to the painted border, or the whole connected piece.
 */
export class PaintTool implements Tool {
  readonly id: string;
  #painting: Painting | null = null;

  constructor(
    private readonly host: DeformHost,
    private readonly subject: Subject,
  ) {
    this.id = `paint-${subject.kind}`;
  }

  down(sample: PointerSample): boolean {
    const scene = this.host.scene();
    if (!scene || sample.button !== 0 || !sample.hit) return false;
    const erase = this.#erases(sample);
    const stroke = new Stroke(this.host, scene);
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
    const { base, erase, stroke } = this.#painting;
    const vertices = result({ base, erase, touched: stroke.touched });
    this.host.showPaint({ kind: this.subject.kind, vertices });
    this.#showBrush(sample);
  }

  /** Nothing is committed where nothing changes. */
  #commit(verb: 'paint' | 'erase' | 'fill', change: Change & { readonly canvas: Canvas }): void {
    const { base, erase, canvas } = change;
    if (![...change.touched].some((v) => base.has(v) === erase)) return;
    const label: EditLabel = `${verb}-${this.subject.kind}`;
    this.host.commit(label, canvas.edit(result(change)));
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
  readonly stroke: Stroke;
}

function result({ base, erase, touched }: Change): Uint32Array {
  const out = new Set(base);
  for (const v of touched) {
    if (erase) out.delete(v);
    else out.add(v);
  }
  return Uint32Array.from(out).sort();
}

/** The region of interest. Painting while it is everything starts it anew; emptied, it stays empty. */
export const paintRoi = (host: DeformHost): PaintTool =>
  new PaintTool(host, {
    kind: 'roi',
    canvas: ({ step, selected, rest }, _, erase) => ({
      base: step.roi === 'all' && !erase ? new Uint32Array() : toIndices(step.roi, rest.length / 3),
      edit: (vertices) => ({ step: { ...step, roi: recipeSet(vertices, rest.length / 3) }, selected }),
    }),
  });

/** A stroke that begins on a handle extends or erases that one (the selected one first); elsewhere it makes a new one. */
export const paintHandle = (host: DeformHost): PaintTool =>
  new PaintTool(host, {
    kind: 'handle',
    canvas: (scene, first) => {
      const { step, rest } = scene;
      const index = handleUnder(scene, first);
      const handle = index === null ? undefined : step.handles[index];
      return {
        base: handle ? toIndices(handle.vertices, rest.length / 3) : new Uint32Array(),
        edit: (vertices) => setHandleVertices(scene, index, vertices, host.newName(step)),
      };
    },
  });

function handleUnder({ step, selected, rest }: DeformScene, touched: ReadonlySet<number>): number | null {
  const order = step.handles.map((_, i) => i);
  if (selected !== null) order.unshift(selected);
  const found = order.find((i) => {
    const handle = step.handles[i];
    if (handle?.kind !== 'region' || handle.hidden) return false;
    return toIndices(handle.vertices, rest.length / 3).some((v) => touched.has(v));
  });
  return found ?? null;
}
