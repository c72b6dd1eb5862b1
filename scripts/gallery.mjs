// Writes public/gallery/index.json and the gallery's recipes: vertex sets are picked by geometry here, so that
// the recipes can be made again when a model changes. Run by hand: node scripts/gallery.mjs

import { writeFileSync } from 'node:fs';
import { blendExamples } from './gallery/blend.mjs';
import { curveExamples } from './gallery/curves.mjs';
import { deformExamples, firstRecipe } from './gallery/deform.mjs';
import { dressExamples } from './gallery/dress.mjs';
import { hairExamples } from './gallery/hair.mjs';
import { isolineExamples } from './gallery/isolines.mjs';
import { matchExamples } from './gallery/match.mjs';
import { mergeExamples } from './gallery/merge.mjs';
import { folder, MADE, modelOf } from './gallery/models.mjs';
import { transferExamples } from './gallery/transfer.mjs';

const OWN = 'Own work, CC0 1.0';
const HUMAN = 'MakeHuman data, CC0 1.0';

/** What is made to be put on. */
const WORN = ['shirt', 'pants', 'skirt', 'shoe'];

const models = [
  ['dinosaur', 'Dinosaur', OWN],
  ['critter', 'Critter', OWN],
  ['critter-scaled', 'Critter with scales', OWN],
  ['octopus', 'Octopus', OWN],
  ['horse', 'Horse', OWN],
  ['cow', 'Cow', OWN],
  ['dog', 'Dog', OWN],
  ['squid', 'Squid', OWN],
  ['cactus', 'Cactus', OWN],
  ['bar', 'Bar', OWN],
  ['loops', 'Loops', OWN],
  ['wings', 'Wings', OWN],
  ['key', 'Key', OWN],
  ['pipes', 'Pipes', OWN],
  ['block', 'Block', OWN],
  ['moebius', 'Möbius strip', OWN],
  ['sheets', 'Three sheets', OWN],
  ['snake', 'Snake in two', OWN],
  ['body-female', 'Body, female', HUMAN],
  ['body-male', 'Body, male', HUMAN],
  ['body-heavy', 'Body, heavy', HUMAN],
  ['body-soup', 'Body, loose triangles', HUMAN],
  ['body-points', 'Body, points', HUMAN],
  ['head-female', 'Head, female', HUMAN],
  ['head-male', 'Head, male', HUMAN],
  ['head-elf', 'Head, elf', HUMAN],
  ['foot-female', 'Foot, female', HUMAN],
  ['foot-male', 'Foot, male', HUMAN],
  ['foot-child', 'Foot, child', HUMAN],
  ['shirt', 'Shirt', HUMAN],
  ['pants', 'Pants', HUMAN],
  ['skirt', 'Skirt', HUMAN],
  ['shoe', 'Shoe', OWN],
  ['torus', 'Ring', OWN],
  ['nut', 'Nut', OWN],
  ['bear', 'Toy bear', OWN],
  ['rabbit', 'Rabbit', OWN],
];

const examples = [
  ...deformExamples(),
  ...isolineExamples(),
  ...mergeExamples(),
  ...transferExamples(),
  ...(await curveExamples()),
  ...matchExamples(),
  ...(await blendExamples()),
  ...dressExamples(),
  ...hairExamples(),
];

function write(file, value, indent) {
  const text = `${JSON.stringify(value, null, indent)}\n`;
  writeFileSync(new URL(file, folder), text);
  console.log(file.padEnd(40), `${text.length} bytes`);
}

write('recipes/first.json', firstRecipe());
for (const [name, , , made] of examples) write(`recipes/${name}.json`, made);
const index = {
  models: models.map(([name, title, licence]) => ({
    name,
    file: `${name}.ply`,
    title,
    licence,
    vertices: modelOf(name).points.length,
    ...(name.startsWith('head-') && { scalp: true }),
    ...(WORN.includes(name) && { worn: true }),
    ...MADE[name],
  })),
  examples: examples.map(([name, title, model, made]) => ({
    name,
    title,
    model,
    file: `recipes/${name}.json`,
    workspace: made.steps.at(-1).type,
  })),
};
write('index.json', index, 2);
