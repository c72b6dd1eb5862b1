// Renders the gallery's pictures with the app itself: public/gallery/thumbnails/*.webp, of the gallery cards' shape.
// Run by hand after the gallery changed: node scripts/thumbnails.mjs

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { bare, drawn, openStudio } from './lib/studio.mjs';

const gallery = new URL('../public/gallery/', import.meta.url);
const SIZE = { width: 512, height: 384 };
/** The page around the viewport included, so that a model is framed for the picture's shape. */
const PAGE = { width: 2 * SIZE.width + 48 + 300, height: 2 * SIZE.height + 44 + 26 };

const { models, examples } = JSON.parse(readFileSync(new URL('index.json', gallery), 'utf8'));
mkdirSync(new URL('thumbnails/', gallery), { recursive: true });

const { page, close } = await openStudio(PAGE);
try {
  for (const { name } of [...examples, ...models]) {
    await page.evaluate(async (wanted) => {
      const { app } = window.__lissom;
      await app.gallery.open(app.gallery.entries.value.find((entry) => entry.name === wanted));
      await app.evaluator.settled();
    }, name);
    // A card needs less air around a model than a gizmo does.
    await page.evaluate(bare, { distance: 0.87 });
    const picture = await page.evaluate(drawn, SIZE);
    writeFileSync(new URL(`thumbnails/${name}.webp`, gallery), Buffer.from(picture, 'base64'));
    console.log(name);
  }
} finally {
  await close();
}
