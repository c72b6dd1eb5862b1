import { beginnings, betweenPoses } from '../../recipe/steps/curves-poses';
import type { CurvesEdits } from './edits';
import type { CurvesState } from './state';

/** Plays the poses one after the other, and from the last to the first again; the document stays as it is. */
export class Player {
  #frame = 0;

  constructor(
    private readonly edits: CurvesEdits,
    private readonly own: Pick<CurvesState, 'playing'>,
  ) {}

  toggle(): void {
    if (this.own.playing.peek()) this.stop();
    else this.#start();
  }

  /** @returns whether it was playing */
  stop(): boolean {
    if (!this.own.playing.peek()) return false;
    cancelAnimationFrame(this.#frame);
    this.own.playing.value = false;
    this.edits.cancel();
    return true;
  }

  #start(): void {
    const { step } = this.edits;
    if (!step || step.poses.length < 2) return;
    this.own.playing.value = true;
    const times = beginnings(step.poses);
    const length = times.at(-1)!;
    let first: number | undefined;
    const next = (now: number): void => {
      first ??= now;
      // An edit, an undo, another step: what is playing is no longer what is open.
      if (this.edits.step !== step) {
        this.own.playing.value = false;
        return;
      }
      const at = ((now - first) / 1000) % length;
      const k = Math.max(
        0,
        times.findLastIndex((time) => time <= at),
      );
      const part = (at - times[k]!) / (times[k + 1]! - times[k]!);
      const [a, b] = [step.poses[k]!, step.poses[(k + 1) % step.poses.length]!];
      this.edits.preview('', betweenPoses(step, a, b, part));
      this.#frame = requestAnimationFrame(next);
    };
    this.#frame = requestAnimationFrame(next);
  }
}
