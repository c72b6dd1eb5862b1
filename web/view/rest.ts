import type { OrthographicCamera, PerspectiveCamera, WebGLRenderer } from 'three';
import { drawsInSoftware } from './software';
import { StillPicture } from './still';

/** Nothing has moved for so many ms: the picture may be perfected. */
const CALM = 150;
const PICTURES = 32;
/** A slow machine stops after so many ms, with the few it has. */
const PATIENCE = 4000;
const FEWEST = 4;

/** While nothing moves, the picture converges; whatever stirs starts it over. */
export class Rest {
  readonly #still = new StillPicture();
  #timer: ReturnType<typeof setTimeout> | undefined;
  readonly #pictures: number;
  #due = false;
  #since = 0;

  /** @param request  asks for one more picture */
  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly request: () => void,
  ) {
    this.#pictures = drawsInSoftware(renderer.getContext()) ? FEWEST : PICTURES;
  }

  /** The next picture is one of many that make a resting one. */
  get due(): boolean {
    return this.#due;
  }

  stirred(): void {
    clearTimeout(this.#timer);
    this.#due = false;
    this.#still.restart();
  }

  /** After a moving picture: perhaps it was the last one. */
  wait(): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => {
      this.#due = StillPicture.possible(this.renderer);
      this.#since = performance.now();
      this.request();
    }, CALM);
  }

  draw(camera: PerspectiveCamera | OrthographicCamera, render: (frame: number) => void): void {
    this.#still.take(this.renderer, camera, render);
    const spent = performance.now() - this.#since;
    this.#due = this.#still.count < (spent < PATIENCE ? this.#pictures : FEWEST);
    if (this.#due) this.request();
  }

  /** Puts what has converged so far on a canvas that was used for something else. @returns whether there was any */
  drawAgain(): boolean {
    return this.#still.show(this.renderer);
  }

  dispose(): void {
    clearTimeout(this.#timer);
    this.#still.dispose();
  }
}
