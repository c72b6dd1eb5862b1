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
 * @returns the page, and `close`, which ends browser and server
 */
export async function openStudio(size, port = 5187) {
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
    await page.goto(server.resolvedUrls.local[0]);
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
export async function drawn({ width, height, quality = 0.85 }) {
  const { viewport } = window.__lissom.app;
  const image = await createImageBitmap(await viewport.screenshot(2 * width, 2 * height));
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
