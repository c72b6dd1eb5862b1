// Renders the gallery's pictures with the app itself: public/gallery/thumbnails/*.webp, of the gallery cards' shape.
// Run by hand after the gallery changed: node scripts/gallery/thumbnails.mjs [name ...]

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { bare, cameraOnHead, drawn, openStudio } from '../lib/studio.mjs';
import { folder as gallery } from './models.mjs';

const SIZE = { width: 512, height: 384 };
/** Of light and shade for models; of strands, thinner than a pixel, for hair. */
const SAMPLES = { model: 2, hair: 6 };
/** The page around the viewport included, so that a model is framed for the picture's shape. */
const PAGE = { width: 2 * SIZE.width + 48 + 300, height: 2 * SIZE.height + 44 + 26 };

const { models, examples } = JSON.parse(readFileSync(new URL('index.json', gallery), 'utf8'));
mkdirSync(new URL('thumbnails/', gallery), { recursive: true });

const wanted = process.argv.slice(2);
const all = [...examples, ...models].filter(({ name }) => wanted.length === 0 || wanted.includes(name));
/** Faces are looked at from near, a little from the side. */
const OF_FACE = /^face-|^curves-(brow|ears)$/;
/** A card needs less air around a model than a gizmo does; what is taller than the model it is framed by needs it. */
const distanceOf = (name) => (name === 'blend-bodies' ? 1.04 : 0.87);
const isHair = ({ name }) => name.startsWith('hair-');
await pictures(
  all.filter((entry) => !isHair(entry)),
  false,
);
await pictures(all.filter(isHair), true);

/** In the page: draws so many of the strands, 0 to 1. */
async function strandShare(share) {
  const { state } = await window.__lissom.app.wings.load('hair');
  state.share.value = share;
}

/** @param ofHair  thousands of strands: seen from the front, and drawn whole for the picture only */
async function pictures(entries, ofHair) {
  if (entries.length === 0) return;
  const { page, close } = await openStudio(PAGE, { quick: true });
  page.setDefaultTimeout(300_000);
  try {
    for (const { name } of entries) {
      if (ofHair) await page.evaluate(strandShare, 0.01);
      await page.evaluate(async (title) => {
        const { app } = window.__lissom;
        await app.gallery.open(app.gallery.entries.value.find((entry) => entry.name === title));
        await app.evaluator.settled();
        // What got a pose is looked at without the model that has it, and without handles.
        const { handles = [] } = app.evaluator.result.peek().step;
        if (title.startsWith('transfer-')) await app.commands.run('transfer.deform');
        else if (title.startsWith('match-')) app.wings.get('match').actions.lookAll('skin');
        else if (handles.some(({ kind }) => kind === 'point')) await app.commands.run('step.apply');
        await app.evaluator.settled();
      }, name);
      await page.evaluate(bare, { distance: distanceOf(name) });
      if (OF_FACE.test(name)) await page.evaluate(cameraOnHead, { azimuth: 18, share: 0.82 });
      if (ofHair) {
        await page.evaluate(cameraOnHead);
        await page.evaluate(strandShare, 1);
      }
      const samples = ofHair ? SAMPLES.hair : SAMPLES.model;
      const picture = await page.evaluate(drawn, { ...SIZE, samples });
      writeFileSync(new URL(`thumbnails/${name}.webp`, gallery), Buffer.from(picture, 'base64'));
      console.log(name);
    }
  } finally {
    await close();
  }
}
