import type { CurvesStep } from '../../recipe/steps/curves';
import { towards } from './edits';
import type { CurvesHost, CurvesLabel } from './host';
import type { Grip } from './items';

type Making = () => CurvesStep | Promise<CurvesStep>;

/**
 * One drag of a curve, shown no further than the surface stays whole. Only the newest wish is looked at, and the drag is
 * committed once that has been shown.
 */
export class GuardedEdit {
  #wanted: Making | null = null;
  #shown: CurvesStep | null = null;
  #running = false;
  #label: CurvesLabel | null = null;
  #over = false;

  constructor(
    private readonly host: CurvesHost,
    private readonly from: CurvesStep,
    private readonly selected: Grip,
  ) {}

  offer(making: Making): void {
    this.#wanted = making;
    if (!this.#running) void this.#run();
  }

  finish(label: CurvesLabel): void {
    this.#label = label;
    if (!this.#running) this.#end();
  }

  cancel(): void {
    this.#over = true;
    this.host.showStopped(false);
    this.host.cancel();
  }

  async #run(): Promise<void> {
    this.#running = true;
    try {
      while (this.#wanted && !this.#over) {
        const making = this.#wanted;
        this.#wanted = null;
        const to = await making();
        const share = this.from.options.guard === 'none' ? 1 : await this.host.share(this.from, to);
        if (this.#over) break;
        this.#shown = share < 1 ? towards(this.from, to, share) : to;
        this.host.showStopped(share < 1);
        this.host.preview({ step: this.#shown, selected: this.selected });
      }
    } catch (error) {
      if (!this.#over) this.host.failed(error);
    } finally {
      this.#running = false;
    }
    if (this.#label) this.#end();
  }

  #end(): void {
    if (this.#over || !this.#label) return;
    this.#over = true;
    this.host.showStopped(false);
    if (this.#shown) this.host.commit(this.#label, { step: this.#shown, selected: this.selected });
    else this.host.cancel();
  }
}
