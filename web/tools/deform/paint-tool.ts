import { toIndices } from '../../core/vertex-set';
import type { PointerSample } from '../../view/types';
import type { Tool } from '../tool';
import { recipeSet, setHandleVertices } from './edits';
import type { DeformEdit, DeformHost, DeformScene, EditLabel } from './host';
import { radiusOf, Stroke } from './stroke';

/** What a paint tool paints: the set it starts from, and the edit a new set makes. */
interface Canvas {
  readonly kind: 'roi' | 'handle';
  base(scene: DeformScene, erase: boolean): Uint32Array;
  edit(scene: DeformScene, vertices: Uint32Array): DeformEdit;
}

/**
 * Paints a vertex set with a round brush on the surface. Alt (or the erase switch) takes away;
 * Shift+click fills up to the painted border, or the whole connected piece.
 */
export class PaintTool implements Tool {
  readonly id: string;
  #stroke: Painting | null = null;

  constructor(
    private readonly host: DeformHost,
    private readonly canvas: Canvas,
  ) {
    this.id = `paint-${canvas.kind}`;
  }

  down(sample: PointerSample): boolean {
    const scene = this.host.scene();
    if (!scene || sample.button !== 0 || !sample.hit) return false;
    const erase = this.#erases(sample);
    const base = new Set(this.canvas.base(scene, erase));
    if (sample.shift) {
      const filled = scene.graph.flood(sample.hit.vertex, (v) => base.has(v) === erase);
      this.#commit('fill', { scene, base, erase, touched: scene.mirrored(filled) });
      return true;
    }
    this.#stroke = { scene, base, erase, stroke: new Stroke(this.host, scene) };
    this.move([sample]);
    return true;
  }

  move(samples: readonly PointerSample[]): void {
    if (!this.#stroke) return;
    const { base, erase, stroke } = this.#stroke;
    stroke.extend(samples);
    const vertices = result({ base, erase, touched: stroke.touched });
    this.host.showPaint({ kind: this.canvas.kind, vertices });
    const sample = samples.at(-1);
    if (sample) this.#showBrush(sample);
  }

  up(sample: PointerSample): void {
    this.move([sample]);
    const painting = this.#stroke;
    this.#stroke = null;
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
    this.#stroke = null;
    this.host.showPaint(null);
    this.host.view.setBrush(null);
  }

  /** Nothing is committed where nothing changes. */
  #commit(verb: 'paint' | 'erase' | 'fill', change: Change & { readonly scene: DeformScene }): void {
    const { base, erase } = change;
    if (![...change.touched].some((v) => base.has(v) === erase)) return;
    const label: EditLabel = `${verb}-${this.canvas.kind}`;
    this.host.commit(label, this.canvas.edit(change.scene, result(change)));
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
  readonly scene: DeformScene;
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
    base: ({ step, rest }, erase) =>
      step.roi === 'all' && !erase ? new Uint32Array() : toIndices(step.roi, rest.length / 3),
    edit: ({ step, selected, rest }, vertices) => ({
      step: { ...step, roi: recipeSet(vertices, rest.length / 3) },
      selected,
    }),
  });

/** The selected region handle, or a new one where none is selected. */
export const paintHandle = (host: DeformHost): PaintTool =>
  new PaintTool(host, {
    kind: 'handle',
    base: (scene) => {
      const handle = region(scene);
      return handle ? toIndices(handle.vertices, scene.rest.length / 3) : new Uint32Array();
    },
    edit: (scene, vertices) =>
      setHandleVertices(scene, region(scene) ? scene.selected : null, vertices, host.newName(scene.step)),
  });

function region({ step, selected }: DeformScene) {
  const handle = selected === null ? undefined : step.handles[selected];
  return handle?.kind === 'region' ? handle : undefined;
}
