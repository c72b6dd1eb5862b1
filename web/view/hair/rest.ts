import type { OrthographicCamera, PerspectiveCamera, WebGLRenderer } from 'three';
import { jitter, StillPicture } from './still';

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
  #due = false;
  #since = 0;

  /** @param request  asks for one more picture */
  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly request: () => void,
  ) {}

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
    this.#add(camera, render);
    const spent = performance.now() - this.#since;
    this.#due = this.#still.count < (spent < PATIENCE ? PICTURES : FEWEST);
    if (this.#due) this.request();
  }

  /** One picture of `samples` at once, left on the canvas. */
  drawAll(
    camera: PerspectiveCamera | OrthographicCamera,
    samples: number,
    render: (frame: number) => void,
  ): void {
    this.stirred();
    for (let i = 0; i < samples; i++) this.#add(camera, render);
    this.#still.restart();
  }

  dispose(): void {
    clearTimeout(this.#timer);
    this.#still.dispose();
  }

  #add(camera: PerspectiveCamera | OrthographicCamera, render: (frame: number) => void): void {
    const { width, height } = this.renderer.domElement;
    const frame = this.#still.count;
    const [x, y] = jitter(frame);
    camera.setViewOffset(width, height, x, y, width, height);
    render(frame + 1);
    camera.clearViewOffset();
    this.#still.add(this.renderer);
  }
}
