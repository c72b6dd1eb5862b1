// Renders the gallery's pictures with the app itself: public/gallery/thumbnails/*.webp, of the gallery cards' shape.
// Run by hand after the gallery changed: node scripts/thumbnails.mjs

import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { chromium } from '@playwright/test';
import { createServer } from 'vite';

const gallery = new URL('../public/gallery/', import.meta.url);
const SIZE = { width: 512, height: 384 };
/** Drawn larger and scaled down: smooth edges. */
const DRAWN = { width: 1024, height: 768 };
/** What the page puts around the viewport, so that a model is framed for the picture's shape. */
const AROUND = { width: 48 + 300, height: 44 + 26 };

const { models, examples } = JSON.parse(readFileSync(new URL('index.json', gallery), 'utf8'));
mkdirSync(new URL('thumbnails/', gallery), { recursive: true });

const server = await createServer({
  configFile: 'vite.config.ts',
  server: { port: 5187 },
  logLevel: 'error',
});
await server.listen();
const executablePath = [process.env.CHROMIUM_PATH, '/usr/bin/chromium'].find(
  (file) => file && existsSync(file),
);
const sandbox = process.getuid?.() === 0 ? ['--no-sandbox'] : [];
const browser = await chromium.launch({
  ...(executablePath && { executablePath }),
  args: [...sandbox, '--enable-unsafe-swiftshader', '--use-angle=swiftshader'],
});
try {
  const page = await browser.newPage({
    viewport: {
      width: DRAWN.width + AROUND.width,
      height: DRAWN.height + AROUND.height,
    },
  });
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.goto(server.resolvedUrls.local[0]);
  await page.waitForFunction(() => '__lissom' in window);
  await page.evaluate(() => window.__lissom.ready);
  for (const { name } of [...examples, ...models]) {
    const picture = await page.evaluate(picturesOf, { name, drawn: DRAWN, size: SIZE });
    writeFileSync(new URL(`thumbnails/${name}.webp`, gallery), Buffer.from(picture, 'base64'));
    console.log(name);
  }
} finally {
  await browser.close();
  await server.close();
}

/** In the page: opens one entry, leaves out everything but the model, and draws it. @returns base64 */
async function picturesOf({ name, drawn, size }) {
  const { app } = window.__lissom;
  await app.gallery.open(app.gallery.entries.value.find((entry) => entry.name === name));
  await app.evaluator.settled();
  app.state.display.value = { ...app.state.display.value, grid: false };
  app.viewport.setRegions([]);
  app.viewport.setMarkers([]);
  app.viewport.setView('home');
  await new Promise((done) => setTimeout(done, 300));
  // A card needs less air around a model than a gizmo does.
  const { position, target, orthographic } = app.viewport.camera;
  const nearer = position.map((x, i) => target[i] + 0.87 * (x - target[i]));
  app.viewport.camera = { position: nearer, target, orthographic };
  const image = await createImageBitmap(await app.viewport.screenshot(drawn.width, drawn.height));
  const canvas = new OffscreenCanvas(size.width, size.height);
  const context = canvas.getContext('2d');
  context.imageSmoothingQuality = 'high';
  context.drawImage(image, 0, 0, size.width, size.height);
  const blob = await canvas.convertToBlob({ type: 'image/webp', quality: 0.85 });
  return btoa(String.fromCharCode(...new Uint8Array(await blob.arrayBuffer())));
}
