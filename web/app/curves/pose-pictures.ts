// Small pictures of the poses that are kept, made while nothing else goes on.

import { effect } from '@preact/signals';
import { isCancelled } from '../../core/errors';
import type { CurvesStep } from '../../recipe/recipe';
import type { CurvePose } from '../../recipe/steps/curves-edits';
import { takePose } from '../../recipe/steps/curves-poses';
import type { ViewportPort } from '../../view/types';
import type { Evaluation } from '../evaluated';
import type { WingParts } from '../wing-parts';
import type { CurvesState } from './state';

/** Twice what the list shows, in pixels. */
export const POSE_PICTURE = { width: 112, height: 84 } as const;
/** Ms without an edit before pictures are made. */
const QUIET = 300;

export class PosePictures {
  #abort = new AbortController();
  #wait: ReturnType<typeof setTimeout> | undefined;
  readonly #stop: () => void;

  constructor(
    private readonly viewport: Pick<ViewportPort, 'thumbnail'>,
    private readonly parts: Pick<WingParts, 'state' | 'evaluator' | 'runner' | 'messages'>,
    private readonly own: CurvesState,
  ) {
    this.#stop = effect(() => {
      const step = own.step.value;
      const shown = parts.evaluator.result.value;
      this.#pause();
      const still = !parts.state.previewing.value && !own.playing.value && !parts.state.viewing.value;
      if (still && step && shown?.settled && shown.step.id === step.id)
        this.#wait = setTimeout(() => {
          this.#make(step, shown).catch((error: unknown) => {
            if (!isCancelled(error)) this.parts.messages.failed(error);
          });
        }, QUIET);
    });
  }

  dispose(): void {
    this.#stop();
    this.#pause();
    for (const url of this.own.posePictures.peek().values()) URL.revokeObjectURL(url);
    this.own.posePictures.value = new Map();
  }

  #pause(): void {
    clearTimeout(this.#wait);
    this.#abort.abort();
  }

  async #make(step: CurvesStep, shown: Evaluation): Promise<void> {
    this.#abort = new AbortController();
    const { signal } = this.#abort;
    const { runner } = this.parts;
    const { posePictures } = this.own;
    const [input] = shown.inputs;
    const wanted = new Map(step.poses.map((pose) => [pictureKey(step, pose), pose]));
    for (const [key, pose] of wanted) {
      if (posePictures.peek().has(key)) continue;
      const { curves } = takePose(step, pose);
      const { positions } = await runner.ask(shown.recipe, step.id, 'posedBy', { curves }, { signal });
      // What is on screen may be another model by now.
      if (signal.aborted || this.parts.evaluator.result.peek()?.inputs[0] !== input) return;
      const picture = await this.viewport.thumbnail(positions, POSE_PICTURE.width, POSE_PICTURE.height);
      if (signal.aborted) return;
      posePictures.value = new Map(posePictures.peek()).set(key, URL.createObjectURL(picture));
    }
    const before = posePictures.peek();
    const kept = new Map([...before].filter(([key]) => wanted.has(key)));
    for (const [key, url] of before) if (!kept.has(key)) URL.revokeObjectURL(url);
    if (kept.size < before.size) posePictures.value = kept;
  }
}

/** All that a picture shows: the step as the pose has it. Poses that look alike share one. */
export const pictureKey = (step: CurvesStep, pose: CurvePose): string =>
  JSON.stringify({ ...takePose(step, pose), poses: [] });
