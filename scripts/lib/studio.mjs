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

/** In the page: a picture of the viewport alone, drawn larger and scaled down. @returns base64 of a WebP file */
export async function drawn({ width, height, samples, quality = 0.85 }) {
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
  app.state.hair.show.value = { ...app.state.hair.show.value, curves: false, support: false };
  await drawn();
  app.viewport.setRegions([]);
  app.viewport.setMarkers([]);
  app.viewport.setView(view);
  await drawn();
  const { position, target, orthographic } = app.viewport.camera;
  const nearer = position.map((x, i) => target[i] + distance * (x - target[i]));
  app.viewport.camera = camera ?? { position: nearer, target, orthographic };
  return app.viewport.camera;
}

/**
 * In the page: the camera that sees head and hair whole, from the front and a little from the side.
 *
 * @param azimuth  degrees from straight in front, to the head's left
 */
export function cameraOnHair({ azimuth = 32, elevation = 9, air = 1.06 } = {}) {
  const { app } = window.__lissom;
  const { strands, positions } = app.evaluator.result.peek();
  const points = [];
  for (let v = 0; v < positions.length; v += 60) points.push([...positions.subarray(v, v + 3)]);
  const count = strands?.offsets.length ?? 0;
  // A few strands stand off: what most of them keep to is the picture.
  for (let s = 0; s + 1 < count; s += 40) {
    const tip = 3 * (strands.offsets[s + 1] - 1);
    points.push([0, 1, 2].map((k) => strands.points[tip + k] + strands.origin[k]));
  }
  const range = (k) => {
    const values = points.map((p) => p[k]).sort((a, b) => a - b);
    return [values[Math.floor(0.005 * values.length)], values[Math.ceil(0.995 * values.length) - 1]];
  };
  const box = [0, 1, 2].map(range);
  const target = box.map(([low, high]) => (low + high) / 2);
  const [a, e] = [azimuth, elevation].map((degrees) => (degrees * Math.PI) / 180);
  const from = [Math.cos(e) * Math.sin(a), Math.sin(e), Math.cos(e) * Math.cos(a)];
  const { clientWidth, clientHeight } = document.querySelector('main.stage canvas');
  let distance = 3 * Math.max(...box.map(([low, high]) => high - low));
  for (let i = 0; i < 4; i++) {
    app.viewport.camera = {
      target,
      orthographic: false,
      position: target.map((x, k) => x + distance * from[k]),
    };
    let widest = 0;
    for (let corner = 0; corner < 8; corner++) {
      const { x, y } = app.viewport.project(box.map((ends, k) => ends[(corner >> k) & 1]));
      widest = Math.max(widest, Math.abs((2 * x) / clientWidth - 1), Math.abs((2 * y) / clientHeight - 1));
    }
    distance *= widest * air;
  }
  return app.viewport.camera;
}
