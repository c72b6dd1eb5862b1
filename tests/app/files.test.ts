import { expect, test } from 'vitest';
import { readModel, readProject } from '../../web/io/index';
import { parseRecipe } from '../../web/recipe/parse';
import { PIXEL } from '../io/pixel';
import { Browser, blindViewport, CUBE_OBJ, file, MemoryStorage, Tab } from './world';

test('an opened mesh becomes a recipe of one step, and its report is there', async () => {
  const tab = new Tab();
  await tab.openCube();
  expect(tab.app.document.recipe.models).toEqual({ cube: { file: 'cube.obj' } });
  expect(tab.app.state.title.value).toBe('cube');
  expect(tab.app.state.importReport.value).toMatchObject({ file: 'cube.obj', facts: { vertices: 8 } });
});

test.each([
  ['an empty file', 'empty.obj', ''],
  ['a text that is no mesh', 'letter.ply', 'Dear reader,'],
  ['a recipe with an unknown field', 'recipe.json', '{"lissom":1,"models":{},"steps":[],"bones":[]}'],
  ['an archive that is none', 'project.zip', 'PK?'],
  [
    'a recipe whose mesh is not there',
    'recipe.json',
    '{"lissom":1,"models":{"a":{"file":"a.ply"}},"steps":[]}',
  ],
])('%s says what is wrong and changes nothing', async (_, name, content) => {
  const tab = new Tab();
  await tab.openCube();
  const { recipe } = tab.app.document;
  await tab.app.files.openFiles([file(name, content)]);
  expect(tab.app.document.recipe).toBe(recipe);
  expect(tab.toasts).toHaveLength(1);
  expect(tab.toasts[0]).not.toMatch(/[{}]/);
  expect(tab.app.state.busy.value).toBeNull();
});

test('a project file holds the recipe and the mesh, and opens again', async () => {
  const tab = new Tab();
  await tab.openCube();
  await tab.addHandle([0], 'Tip');
  await tab.app.files.save();
  const [saved] = tab.saved;
  expect(saved?.name).toBe('cube.zip');
  const project = readProject(saved!.bytes);
  expect(parseRecipe(project.recipeJson)).toEqual(tab.app.document.recipe);
  expect(new TextDecoder().decode(project.files.get('cube.obj'))).toBe(CUBE_OBJ);

  const other = new Tab();
  await other.app.files.openFiles([file('cube.zip', saved!.bytes)]);
  await other.app.evaluator.settled();
  expect(other.app.document.recipe).toEqual(tab.app.document.recipe);
  expect(other.app.state.facts.value?.vertices).toBe(8);
});

test('two files of one name and different content are two files', async () => {
  const tab = new Tab();
  await tab.openCube();
  const higher = CUBE_OBJ.replaceAll(' 1\n', ' 9\n');
  await tab.app.files.openFiles([file('cube.obj', higher)]);
  await tab.app.evaluator.settled();
  expect(tab.app.document.recipe.models).toEqual({ cube: { file: 'cube 2.obj' } });
});

test.each(['obj', 'ply', 'stl', 'glb'] as const)('an export to %s has the edited shape', async (format) => {
  const tab = new Tab();
  await tab.openCube();
  await tab.addHandle([0, 1, 2, 3, 4, 5, 6, 7], 'All');
  tab.deform.setPose(0, { translation: [10, 0, 0] });
  await tab.app.files.exportModel(format);
  const [saved] = tab.saved;
  expect(saved?.name).toBe(`cube.${format}`);
  const { positions } = readModel(saved!.bytes, saved!.name).model;
  expect(positions.reduce((least, x, i) => (i % 3 === 0 ? Math.min(least, x) : least), Infinity)).toBe(10);
  if (format === 'obj' || format === 'ply')
    expect(tab.toasts.at(-1)).toBe(`cube.${format} written: 8 vertices, 0 reordered.`);
});

test('a name that recipes do not take is made to fit', async () => {
  const tab = new Tab();
  await tab.app.files.openFiles([file('*ödd* (näme)/x#.obj'.replace('/', '_'), CUBE_OBJ)]);
  expect(() => parseRecipe(tab.app.document.recipe)).not.toThrow();
});

test('a link of a dropped-in mesh offers the project file instead', async () => {
  const tab = new Tab();
  await tab.openCube();
  expect(await tab.app.share.link()).toMatchObject({ kind: 'needs-file' });
});

/** A tab that can take pictures, of one pixel each. */
function photographer(): { tab: Tab; asked: number[][] } {
  const asked: number[][] = [];
  const viewport = blindViewport({
    size: { width: 800, height: 500 },
    screenshot: async (width, height, { onProgress } = {}) => {
      asked.push([width, height]);
      onProgress?.(0.5);
      return new Blob([PIXEL as BlobPart]);
    },
  });
  return { tab: new Tab(new Browser(), new MemoryStorage(), viewport), asked };
}

test('a still picture is as wide as a large screen, has the recipe inside and opens as what it shows', async () => {
  const { tab, asked } = photographer();
  await tab.openCube();
  await tab.addHandle([0], 'Tip');
  await tab.app.commands.run('file.screenshot');
  expect(asked).toEqual([[3840, 2400]]);
  const [picture] = tab.saved;
  expect(picture!.name).toBe('cube.png');
  expect(tab.app.state.busy.value).toBeNull();

  const other = new Tab();
  await other.app.files.openFiles([file('cube.png', picture!.bytes), file('cube.obj', CUBE_OBJ)]);
  await other.app.evaluator.settled();
  expect(other.toasts).toEqual([]);
  expect(other.app.document.recipe).toEqual(tab.app.document.recipe);
});

test('a picture of someone else’s, or one that arrived damaged, is told apart and changes nothing', async () => {
  const { tab } = photographer();
  await tab.openCube();
  const { recipe } = tab.app.document;
  await tab.app.commands.run('file.screenshot');
  const whole = tab.saved[0]!.bytes;
  const bent = whole.slice();
  bent[whole.length - 40]! ^= 1;
  tab.app.state.toasts.value = [];
  for (const bytes of [PIXEL, bent, whole.slice(0, -20), new Uint8Array([255, 216, 255])])
    await tab.app.files.openFiles([file('holiday.png', bytes)]);
  expect(tab.app.document.recipe).toBe(recipe);
  expect(tab.toasts.map((text) => /without a recipe|is damaged: [^.:]+/.exec(text)?.[0])).toEqual([
    'without a recipe',
    'is damaged: the text in it does not match its check',
    'is damaged: it ends in the middle',
    'is damaged: it does not begin as a PNG picture does',
  ]);
});
