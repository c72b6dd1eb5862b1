// Markers: a press on a model sets one, a press on one takes hold of it; both slide over the surface until it is let go.

import type { PointerSample, Vec3 } from '../../view/types';
import { type Drag, DragTool } from '../drag-tool';
import { isHidden } from '../sight';
import { clickSlop, distance } from '../tool';
import { markerFor } from './edits';
import { type MatchHost, type MatchScene, pointNear } from './host';
import { pointOf, type Spot, spotAt } from './places';

/** Where a model's markers are; `null`: not on this one, or out of sight. */
const inSight = ({ view }: MatchHost, { step, at, surface }: MatchScene): (Vec3 | null)[] =>
  step.markers.map((marker) => {
    const point = marker[at] == null ? null : pointOf(surface, marker[at]);
    return point && !isHidden(view, point) ? point : null;
  });

export class MarkerTool extends DragTool {
  /** @param places  false: those that are there are picked and moved, and elsewhere the camera has the pointer */
  constructor(
    private readonly host: MatchHost,
    private readonly places: boolean,
  ) {
    super();
  }

  protected take(sample: PointerSample): Drag | null {
    const { host } = this;
    const scene = host.scene();
    if (!scene || sample.button !== 0) return null;
    const held = pointNear(host.view, inSight(host, scene), sample);
    if (held !== null) {
      if (held !== scene.marker) host.pickMarker(held);
      return new Sliding(host, scene, sample, held, null);
    }
    if (!this.places) return null;
    const { ghost } = scene;
    const accepted = ghost && pointNear(host.view, [ghost.point], sample) === 0 ? ghost : null;
    if (!accepted && !sample.hit) return null;
    return new Sliding(host, scene, sample, markerFor(scene.step, scene.marker, scene.at), accepted);
  }
}

/** A marker under the pointer. */
class Sliding implements Drag {
  #spot: Spot | null = null;
  #moved = false;
  readonly #isNew: boolean;

  /** @param start  where it is set unless the pointer moves on; `null`: under the pointer */
  constructor(
    private readonly host: MatchHost,
    private readonly scene: MatchScene,
    private readonly first: PointerSample,
    private readonly marker: number,
    start: Spot | null,
  ) {
    this.#isNew = scene.step.markers[marker]?.[scene.at] == null;
    if (!this.#isNew) return;
    this.#spot = start ?? (first.hit && spotAt(scene.surface, first.hit));
    this.#show();
  }

  move(samples: readonly PointerSample[]): void {
    const sample = samples.at(-1);
    if (!sample) return;
    this.#moved ||= distance(this.first, sample) > clickSlop(sample.pointerType);
    if (!this.#moved || !sample.hit) return;
    this.#spot = spotAt(this.scene.surface, sample.hit);
    this.#show();
  }

  finish(sample: PointerSample): void {
    this.move([sample]);
    if (this.#spot) this.host.commitMarker(this.#isNew ? 'place' : 'move', this.marker, this.#spot);
    else this.host.cancel();
  }

  cancel(): void {
    this.host.cancel();
  }

  #show(): void {
    if (this.#spot) this.host.previewMarker(this.marker, this.#spot);
  }
}
