import type { PointerSample } from '../../view/types';
import { pointAt } from '../geometry';
import { isHidden } from '../sight';
import { clickSlop, distance, type Tool } from '../tool';
import type { MergeHost, MergeScene } from './host';
import type { Loop } from './loops';
import { addKey, moveKey, type Pin, pinsOf, removeKey, slot } from './pins';

/** How near, in CSS pixels, the pointer must come to a pin or a loop. */
const PIN_REACH = 14;
const LOOP_REACH = 12;

interface Drag {
  readonly scene: MergeScene;
  readonly pin: Pin;
  readonly start: PointerSample;
  moved: boolean;
}

/**
 * Openings and pins of one pane. A click on an opening picks it; on a loop that is joined it sets a pin; a pin is
 * dragged along its loop; Alt+click takes one away. Elsewhere the camera turns.
 */
export class PinTool implements Tool {
  #drag: Drag | null = null;

  constructor(private readonly host: MergeHost) {}

  down(sample: PointerSample): boolean {
    const scene = this.host.scene();
    if (!scene || sample.button !== 0) return false;
    const pin = this.#pinAt(scene, sample);
    if (pin && sample.alt) this.#remove(scene, pin);
    else if (pin) {
      this.#drag = { scene, pin, start: sample, moved: false };
      this.host.select(pin.number);
    } else return this.#press(scene, sample);
    return true;
  }

  move(samples: readonly PointerSample[]): void {
    const sample = samples.at(-1);
    const drag = this.#drag;
    if (!drag || !sample) return;
    drag.moved ||= distance(drag.start, sample) > clickSlop(sample.pointerType);
    if (drag.moved) this.host.preview(this.#dragged(drag, sample), drag.pin.number);
  }

  up(sample: PointerSample): void {
    const drag = this.#drag;
    this.#drag = null;
    if (drag?.moved) this.host.commit('move-pin', this.#dragged(drag, sample), drag.pin.number);
  }

  hover(sample: PointerSample): void {
    const scene = this.host.scene();
    const over = scene && !this.#pinAt(scene, sample) && this.#loopAt(this.#openings(scene), scene, sample);
    this.host.hoverLoop(over ? over.loop : null);
  }

  leave(): void {
    this.host.hoverLoop(null);
  }

  cancel(): void {
    this.#drag = null;
    this.host.cancel();
  }

  #press(scene: MergeScene, sample: PointerSample): boolean {
    const { side } = this.host;
    const joined = scene.boundaries.map((boundary) => boundary[side]);
    const own = this.#loopAt(joined, scene, sample);
    if (own) {
      const boundaries = scene.boundaries.map((boundary) =>
        boundary[side] === own.loop ? addKey(boundary, side, own.vertex, scene.positions) : boundary,
      );
      const added = pinsOf(boundaries).find(({ vertices }) => vertices[slot(side)] === own.vertex);
      if (added) this.host.commit('add-pin', boundaries, added.number);
      return true;
    }
    const opening = this.#loopAt(this.#openings(scene), scene, sample);
    if (opening) this.host.pickLoop(opening.loop);
    return opening !== null;
  }

  #remove(scene: MergeScene, pin: Pin): void {
    const boundaries = scene.boundaries.map((boundary, i) =>
      i === pin.boundary ? removeKey(boundary, pin.key) : boundary,
    );
    this.host.commit('remove-pin', boundaries, null);
  }

  /** Openings that are not joined yet. */
  #openings({ loops, step }: MergeScene): Loop[] {
    const taken = new Set(step.boundaries.flatMap((boundary) => boundary[this.host.side]));
    return loops.filter((loop) => !loop.some((vertex) => taken.has(vertex)));
  }

  #dragged({ scene, pin }: Drag, sample: PointerSample) {
    const { side } = this.host;
    return scene.boundaries.map((boundary, i) => {
      if (i !== pin.boundary) return boundary;
      const near = this.#nearest(boundary[side], scene, sample);
      return near ? moveKey(boundary, pin.key, side, near.vertex) : boundary;
    });
  }

  #pinAt(scene: MergeScene, { x, y }: PointerSample): Pin | null {
    const { side, view } = this.host;
    let best: Pin | null = null;
    let least = PIN_REACH;
    for (const pin of scene.pins) {
      const at = view.project(pointAt(scene.positions[side], pin.vertices[slot(side)]));
      const off = at.behind ? Infinity : Math.hypot(at.x - x, at.y - y);
      if (off < least) [best, least] = [pin, off];
    }
    return best;
  }

  #loopAt(loops: readonly Loop[], scene: MergeScene, sample: PointerSample) {
    let best: { readonly loop: Loop; readonly vertex: number } | null = null;
    let least = LOOP_REACH;
    for (const loop of loops) {
      const near = this.#nearest(loop, scene, sample);
      if (near && near.off < least) [best, least] = [{ loop, vertex: near.vertex }, near.off];
    }
    return best;
  }

  /** The loop's vertex nearest to the pointer on the screen; one in sight rather than one behind the model. */
  #nearest(loop: Loop, scene: MergeScene, sample: PointerSample) {
    const { view, side } = this.host;
    const places = loop
      .map((vertex) => {
        const point = pointAt(scene.positions[side], vertex);
        const { x, y, behind } = view.project(point);
        return { vertex, point, off: behind ? Infinity : Math.hypot(x - sample.x, y - sample.y) };
      })
      .sort((a, b) => a.off - b.off);
    const inReach = places.slice(0, 12).filter(({ off }) => off < Infinity);
    return inReach.find((place) => !isHidden(view, place.point)) ?? inReach[0];
  }
}
