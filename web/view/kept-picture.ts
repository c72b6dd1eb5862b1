import type { OrthographicCamera, PerspectiveCamera, WebGLRenderer } from 'three';
import { LissomError } from '../core/errors';
import { StillPicture } from './still';
import type { PictureOptions } from './values';

/** Pictures that make one to keep. */
const SAMPLES = 32;
/** So many will do when time is short: with fewer, what is thinner than a pixel shows as dots. */
const FEWEST = 4;
/** A page that is not looked at draws no frames, but goes on after so many ms. */
const UNSEEN = 200;

/** What is pictured. */
export interface Sitter {
  readonly renderer: WebGLRenderer;
  camera(): PerspectiveCamera | OrthographicCamera;
  /** Another number is another picture. */
  state(): number;
  /** Calls back while the canvas has the wanted size and shows no tools, and puts everything back. */
  drawAside(draw: () => void): void;
  /** @param frame  number of the picture, from 1 */
  render(frame: number): void;
}

/** A PNG of many pictures averaged. The page stays at hand; what changes meanwhile starts it over. */
export async function keptPicture(
  sitter: Sitter,
  size: { readonly width: number; readonly height: number },
  { samples: wanted = SAMPLES, patience = Infinity, onProgress, signal }: PictureOptions,
): Promise<Blob> {
  const { renderer } = sitter;
  const samples = StillPicture.possible(renderer) ? wanted : 1;
  const copy = document.createElement('canvas');
  Object.assign(copy, size);
  const still = new StillPicture();
  const begun = performance.now();
  let [state, taken, done] = [sitter.state(), 0, false];
  try {
    while (!done) {
      signal?.throwIfAborted();
      // What has been drawn so far was another picture.
      if (state !== sitter.state()) {
        still.restart();
        [state, taken] = [sitter.state(), 0];
      }
      sitter.drawAside(() => {
        if (samples > 1) still.take(renderer, sitter.camera(), (frame) => sitter.render(frame));
        else sitter.render(1);
        taken++;
        done = taken >= samples || (taken >= FEWEST && performance.now() - begun > patience);
        if (done) copy.getContext('2d')?.drawImage(renderer.domElement, 0, 0);
      });
      onProgress?.(taken / samples);
      if (!done) await breath();
    }
  } finally {
    still.dispose();
  }
  return pngOf(copy);
}

/** @throws LissomError  `screenshot-failed` */
export async function pngOf(canvas: HTMLCanvasElement): Promise<Blob> {
  const blob = await new Promise<Blob | null>((done) => canvas.toBlob(done, 'image/png'));
  if (!blob) throw new LissomError('screenshot-failed', 'The picture could not be made. Try a smaller size.');
  return blob;
}

/** Lets the page and the graphics card catch up. */
const breath = (): Promise<unknown> =>
  Promise.race([new Promise(requestAnimationFrame), new Promise((rested) => setTimeout(rested, UNSEEN))]);
