// Takes the pictures of README.md and docs/: docs/pictures/*. Run by hand: node scripts/pictures.mjs

import { mkdirSync, writeFileSync } from 'node:fs';
import { bare, drawn, openStudio } from './lib/studio.mjs';

const folder = new URL('../docs/pictures/', import.meta.url);
const PAGE = { width: 1152, height: 720 };
const SIZE = { width: 440, height: 400 };
/** The first one is what the app does unless told otherwise; it is framed, the others are seen likewise. */
const WAYS = {
  done: { method: 'implicit', options: { removeShear: true } },
  sheared: { method: 'implicit', options: { removeShear: false } },
  naive: { method: 'naive', options: {} },
};
/** What is bent forwards or sideways between two heights, as shares of the model's own. */
const BENDS = [
  { name: 'bar', model: 'bar', degrees: 135, low: 0.01, high: 0.99, forwards: false, view: 'home' },
  { name: 'body', model: 'body-female', degrees: 90, low: 0.4, high: 0.87, forwards: true, view: 'right' },
  { name: 'critter', model: 'critter', degrees: 90, low: 0.2, high: 0.93, forwards: true, view: 'right' },
];

mkdirSync(folder, { recursive: true });
const { page, close } = await openStudio(PAGE);
try {
  await hero();
  await page.setViewportSize({ width: 2 * SIZE.width + 348, height: 2 * SIZE.height + 70 });
  for (const bend of BENDS) {
    let camera;
    for (const [way, step] of Object.entries(WAYS)) {
      const did = await page.evaluate(opened, { ...bend, ...step });
      camera = await page.evaluate(bare, { view: bend.view, distance: 0.8, camera });
      const picture = await page.evaluate(drawn, SIZE);
      writeFileSync(new URL(`${bend.name}-${way}.webp`, folder), Buffer.from(picture, 'base64'));
      console.log(bend.name, way, did);
    }
  }
} finally {
  await close();
}

/** The first picture as a visitor has it after two drags. */
async function hero() {
  const settled = () => page.evaluate(() => window.__lissom.app.evaluator.settled());
  const drag = async (index, dx, dy) => {
    const { x, y } = await page.evaluate(gripOf, index);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + dx, y + dy, { steps: 5 });
    await page.mouse.up();
    await settled();
  };
  await drag(1, -30, -150);
  await drag(0, 170, -10);
  const turn = page.getByRole('textbox', { name: 'Turn Y' });
  await turn.fill('75');
  await turn.press('Enter');
  await settled();
  await page.mouse.move(60, 700);
  await turn.blur();
  await page.waitForTimeout(1500);
  await page.screenshot({ path: new URL('deform.png', folder).pathname });
}

/** In the page: where to take hold of a handle, by a vertex of it that is in sight. */
function gripOf(index) {
  const { app } = window.__lissom;
  const { step, positions } = app.evaluator.result.peek();
  const { vertices } = step.handles[index];
  const own = vertices.ranges
    ? vertices.ranges.flatMap(([a, b]) => Array.from({ length: b - a + 1 }, (_, i) => a + i))
    : vertices;
  const within = new Set(own);
  const seen = own
    .map((v) => app.viewport.project(positions.subarray(3 * v, 3 * v + 3)))
    .filter(({ x, y }) => within.has(app.viewport.pick(x, y)?.vertex));
  const { left, top } = document.querySelector('canvas').getBoundingClientRect();
  const { x, y } = seen[Math.floor(seen.length / 2)];
  return { x: left + x, y: top + y };
}

/** In the page: a gallery model bent along a circular arc as long as the way between its two handles. */
async function opened({ model, degrees, low, high, forwards, method, options }) {
  const { app } = window.__lissom;
  await app.gallery.open(app.gallery.entries.value.find((entry) => entry.name === model && !entry.recipe));
  await app.evaluator.settled();
  const rest = app.evaluator.result.peek().shown.model.positions;
  const heights = rest.filter((_, i) => i % 3 === 1);
  const foot = heights.reduce((a, b) => Math.min(a, b));
  const tall = heights.reduce((a, b) => Math.max(a, b)) - foot;
  const [from, to] = [foot + low * tall, foot + high * tall];
  const pick = (inside) => [...heights.keys()].filter((v) => inside(heights[v]));
  const angle = (degrees * Math.PI) / 180;
  const [c, s, radius] = [Math.cos(angle), Math.sin(angle), (to - from) / angle];
  // In the plane of the height and `across`: turned by the angle, then set on the arc's end.
  const across = radius * (1 - c) - to * s;
  const up = from + radius * s - to * c;
  const matrix = forwards
    ? [1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, 0, up, across, 1]
    : [c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0, across, up, 0, 1];
  const { recipe } = app.document;
  const step = {
    ...recipe.steps[0],
    method,
    options: { ...recipe.steps[0].options, ...options },
    handles: [
      {
        kind: 'region',
        name: 'Foot',
        vertices: pick((y) => y < from),
        matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
      },
      { kind: 'region', name: 'Top', vertices: pick((y) => y > to), matrix },
    ],
  };
  await app.desk.open({ recipe: { ...recipe, steps: [step] }, title: model });
  await app.evaluator.settled();
  const { whatItDid } = app.wings.get('deform').state;
  for (let i = 0; i < 100 && !whatItDid.value; i++) await new Promise((next) => setTimeout(next, 50));
  const { volumeRatio, edgeRms, worstStretch } = whatItDid.value;
  return `volume ${volumeRatio.toFixed(3)}, edges rms ${edgeRms.toFixed(3)}, worst ${worstStretch.toFixed(2)}`;
}
