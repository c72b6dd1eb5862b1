// Project files and pictures: damaged in their frames and in what they hold.

import { zipSync } from 'fflate';
import { readProject, writeModel, writeProject } from '../../../web/io';
import { pngText, withPngText } from '../../../web/io/png-text';
import { parseRecipe } from '../../../web/recipe/parse';
import { makeModel } from '../../io/make-model';
import { PIXEL } from '../../io/pixel';
import { type Generator, outcomeOf } from '../generator';
import { bytesOf, mutateBytes, word } from '../mutate';

const MESH = writeModel(makeModel([0, 0, 0, 1, 0, 0, 0, 1, 0], [[0, 1, 2]]), 'ply');
const RECIPE = '{"lissom":1,"models":{"a":{"file":"a.ply"}},"steps":[]}';
const PROJECT = writeProject({ recipeJson: RECIPE, files: new Map([['a.ply', MESH]]) });

const archives: readonly Generator[] = [
  {
    kind: 'project',
    run(random) {
      // The packer that packs them has no place for a field of every object.
      const name = word(random).replace('__proto__', 'proto');
      const named = () =>
        zipSync({ 'recipe.json': bytesOf(RECIPE), [`${name}${random.below(9)}`]: MESH, [name]: MESH });
      const file = mutateBytes(random, random.chance(0.5) ? PROJECT : named());
      return outcomeOf(async () => {
        const { recipeJson, files } = readProject(file);
        await outcomeOf(() => parseRecipe(recipeJson));
        await outcomeOf(() => readProject(writeProject({ recipeJson, files })));
      });
    },
  },
  {
    kind: 'picture',
    run(random) {
      const file = mutateBytes(random, withPngText(PIXEL, 'lissom:recipe', RECIPE));
      return outcomeOf(async () => {
        const text = pngText(file, 'a.png', 'lissom:recipe');
        if (text !== undefined) await outcomeOf(() => parseRecipe(text));
        await outcomeOf(() => withPngText(file, 'lissom:recipe', RECIPE));
      });
    },
  },
];
export default archives;
