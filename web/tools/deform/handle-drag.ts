import type { DeformHandle, DeformStep } from '../../recipe/recipe';
import type { PointerSample, Vec3 } from '../../view/types';
import type { Drag } from '../drag-tool';
import { subtract } from '../geometry';
import { clickSlop, distance } from '../tool';
import { shiftHandle, withHandle } from './edits';
import type { DeformHost, EditLabel } from './host';

/** One grab of a handle, from press to release: it follows the pointer in the plane of the screen. */
export class HandleDrag implements Drag {
  #moved = false;
  #latest: DeformStep;

  /**
   * @param step   what the grab starts from; `index` is the handle's place in it
   * @param grip   the point of the model that was taken hold of
   * @param click  what a release without movement means
   */
  constructor(
    private readonly host: DeformHost,
    private readonly step: DeformStep,
    private readonly index: number,
    private readonly start: PointerSample,
    private readonly grip: Vec3,
    private readonly label: EditLabel,
    private readonly click: () => void,
  ) {
    this.#latest = step;
  }

  move(samples: readonly PointerSample[]): void {
    const sample = samples.at(-1);
    if (!sample) return;
    this.#moved ||= distance(sample, this.start) > clickSlop(sample.pointerType);
    if (!this.#moved) return;
    const to = this.host.view.pointOnScreenPlane(sample.x, sample.y, this.grip);
    const handle = this.step.handles[this.index] as DeformHandle;
    this.#latest = withHandle(this.step, this.index, shiftHandle(handle, subtract(to, this.grip)));
    this.host.preview({ step: this.#latest, selected: this.index });
  }

  finish(sample: PointerSample): void {
    this.move([sample]);
    if (this.#moved) this.host.commit(this.label, { step: this.#latest, selected: this.index });
    else this.click();
  }

  cancel(): void {
    this.host.cancel();
  }
}
