// The app in a browser without a window, for scripts that take pictures of it.

import { existsSync } from 'node:fs';
import { chromium } from '@playwright/test';
import { build, preview } from 'vite';

/** Apart from dist/, which may be served to somebody. */
const BUILT = '../build/studio';

/**
 * Builds and serves the site, opens the app and waits until it is ready.
 *
 * @param size  of the page, CSS pixels
 * @param quick  drawn once and not again and again until it is smooth: for what takes seconds a frame without a GPU
 * @returns the page, and `close`, which ends browser and server
 */
export async function openStudio(size, { quick = false, port = 5187 } = {}) {
  const site = { configFile: 'vite.config.ts', build: { outDir: BUILT }, logLevel: 'error' };
  await build(site);
  const server = await preview({ ...site, preview: { port } });
  const executablePath = [process.env.CHROMIUM_PATH, '/usr/bin/chromium'].find(
    (file) => file && existsSync(file),
  );
  const sandbox = process.getuid?.() === 0 ? ['--no-sandbox'] : [];
  const browser = await chromium.launch({
    ...(executablePath && { executablePath }),
    args: [...sandbox, '--enable-unsafe-swiftshader', '--use-angle=swiftshader'],
  });
  const close = async () => {
    await browser.close();
    await server.close();
  };
  try {
    const page = await browser.newPage({ viewport: size });
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await page.goto(`${server.resolvedUrls.local[0]}${quick ? '?test=1' : ''}`, { timeout: 120_000 });
    await page.waitForFunction(() => '__lissom' in window);
    await page.evaluate(async () => {
      await window.__lissom.ready;
      await window.__lissom.app.evaluator.settled();
    });
    return { page, close };
  } catch (error) {
    await close();
    throw error;
  }
}

/**
 * In the page: a picture of the viewport alone, drawn larger and scaled down.
 *
 * @param samples  pictures that it is the mean of; as many as the app takes when left out
 * @returns base64 of a WebP file
 */
export async function drawn({ width, height, quality = 0.85, samples }) {
  const { viewport } = window.__lissom.app;
  const image = await createImageBitmap(await viewport.screenshot(2 * width, 2 * height, { samples }));
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext('2d');
  context.imageSmoothingQuality = 'high';
  context.drawImage(image, 0, 0, width, height);
  const blob = await canvas.convertToBlob({ type: 'image/webp', quality });
  return btoa(String.fromCharCode(...new Uint8Array(await blob.arrayBuffer())));
}

/**
 * In the page: nothing but the model, seen from near, or as `camera` sees it.
 *
 * @returns the camera, for the next picture of the same subject
 */
export async function bare({ view = 'home', distance = 1, camera }) {
  const { app } = window.__lissom;
  const drawn = async () => {
    for (let i = 0; i < 3; i++) await new Promise(requestAnimationFrame);
  };
  app.state.display.value = { ...app.state.display.value, grid: false };
  const hair = app.wings.get('hair')?.state;
  if (hair) hair.show.value = { ...hair.show.value, curves: false, support: false };
  const curves = app.wings.get('curves')?.state;
  if (curves) curves.hidden.value = new Set(curves.step.peek()?.curves.map(({ id }) => id));
  await drawn();
  app.viewport.setRegions([]);
  app.viewport.setView(view);
  await drawn();
  const { position, target, orthographic } = app.viewport.camera;
  const nearer = position.map((x, i) => target[i] + distance * (x - target[i]));
  app.viewport.camera = camera ?? { position: nearer, target, orthographic };
  return app.viewport.camera;
}

/**
 * In the page: the camera that sees a head with its hair from the front and a little from the side, every head as
 * large as any other. Hair that hangs lower than the picture is cut by its edge.
 *
 * @param azimuth  degrees from straight in front, to the head's left
 * @param share    of the picture's height that the head takes
 */
export function cameraOnHead({ azimuth = 32, elevation = 9, share = 0.66 } = {}) {
  const { app } = window.__lissom;
  const { positions } = app.evaluator.result.peek();
  const range = (k) => {
    const values = positions.filter((_, i) => i % 3 === k);
    return [values.reduce((a, b) => Math.min(a, b)), values.reduce((a, b) => Math.max(a, b))];
  };
  const box = [0, 1, 2].map(range);
  const height = box[1][1] - box[1][0];
  const target = box.map(([low, high], k) => (low + high) / 2 - (k === 1 ? 0.04 * height : 0));
  const [a, e] = [azimuth, elevation].map((degrees) => (degrees * Math.PI) / 180);
  const from = [Math.cos(e) * Math.sin(a), Math.sin(e), Math.cos(e) * Math.cos(a)];
  const { clientHeight } = document.querySelector('main.stage canvas');
  const middle = (y) => [target[0], y, target[2]];
  let distance = 3 * height;
  for (let i = 0; i < 4; i++) {
    app.viewport.camera = {
      target,
      orthographic: false,
      position: target.map((x, k) => x + distance * from[k]),
    };
    const [top, bottom] = [box[1][1], box[1][0]].map((y) => app.viewport.project(middle(y)).y);
    distance *= (bottom - top) / clientHeight / share;
  }
  return app.viewport.camera;
}
