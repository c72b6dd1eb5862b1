// How long pictures take.

import type { Desk } from './desk';

/**
 * Milliseconds from one picture to the next while they follow each other: where only the view changes, and where the
 * card moves every vertex first. Medians of turns about, as other work on the machine slows now the one, now the other.
 */
export const pictureTimes = (desk: Desk) =>
  desk.page.evaluate(async () => {
    const { app } = window.__lissom;
    const viewport = app.viewport!;
    const gl = document.querySelector('canvas')!.getContext('webgl2')!;
    const pixel = new Uint8Array(4);
    const pictures = 4;
    const period = (stir: (share: number) => void) =>
      new Promise<number>((resolve) => {
        let drawn = -1; // the first has other work to wait for
        let from = 0;
        const stop = viewport.onDraw(() => {
          gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel); // waits for the card
          if (drawn === 0) from = performance.now();
          if (drawn === pictures) {
            stop();
            resolve((performance.now() - from) / pictures);
            return;
          }
          stir(1 - ++drawn / 20);
        });
        stir(1);
      });
    const result = app.evaluator.result as { value: ReturnType<typeof app.evaluator.result.peek> };
    const { moved } = result.value!;
    const look = () => {
      const { camera } = viewport;
      viewport.camera = camera;
    };
    const move = (share: number) => {
      const table = moved!.table.map((part) => share * part);
      result.value = { ...result.value!, moved: { ...moved!, table } };
    };
    const [alone, moving]: number[][] = [[], []];
    for (let turn = 0; turn < 5; turn++) {
      alone!.push(await period(look));
      moving!.push(await period(move));
    }
    const median = (times: number[]) => times.sort((a, b) => a - b)[Math.floor(times.length / 2)]!;
    return { alone: median(alone!), moving: median(moving!) };
  });
