import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { HairPort } from '../../web/view/hair/types';
import type { ViewModel } from '../../web/view/types';
import { Browser, blindViewport, CUBE_OBJ, file, MemoryStorage, Tab } from './world';

const LINES = 'v 0 1 0\nv 0 2 0\nv 0 3 1\nv 1 1 0\nv 1 2 0\nl 1 2 3\nl 4 5\n';
const WITH_HEAD = `${CUBE_OBJ}\n${LINES.replace(/^l (.*)$/gm, (_, at: string) => `l ${at.replace(/\d/g, (d) => String(8 + Number(d)))}`)}`;

beforeEach(() => vi.stubGlobal('fetch', async () => new Response('', { status: 404 })));
afterEach(() => vi.unstubAllGlobals());

/** A tab with a cube open, and what its viewport shows. */
async function looking() {
  const shown: { model: ViewModel | null; strands: number } = { model: null, strands: 0 };
  const setHair: HairPort['setHair'] = (strands) => {
    shown.strands = strands ? strands.offsets.length - 1 : 0;
  };
  const viewport = blindViewport(
    {
      setModel: (model) => {
        shown.model = model;
      },
    },
    { hair: { setHair, unmounted: () => setHair(null) } as HairPort & { unmounted(): void } },
  );
  const tab = new Tab(new Browser(), new MemoryStorage(), viewport);
  await tab.openCube();
  return { tab, shown };
}

const corners = (model: ViewModel | null): number => (model?.positions.length ?? 0) / 3;

test('a file of lines is looked at alone; the way back leads to the work as it was', async () => {
  const { tab, shown } = await looking();
  await tab.addHandle([0], 'Tip');
  const { state, document, commands, files } = tab.app;
  const { recipe } = document;
  await files.openFiles([file('wig.obj', LINES)]);
  expect(tab.app.state.viewing.value).toMatchObject({ name: 'wig.obj', on: 'nothing', head: null });
  expect([corners(shown.model), shown.strands]).toEqual([0, 2]);
  expect(state.status.value).toContain('Esc');
  await commands.run('hair.end-viewing');
  expect([corners(shown.model), shown.strands]).toEqual([8, 0]);
  expect(document.recipe).toBe(recipe);
  expect(tab.toasts).toEqual([]);
});

test('an edit ends the looking, and so does Escape', async () => {
  const { tab, shown } = await looking();
  const { state, commands, files } = tab.app;
  await files.openFiles([file('wig.obj', LINES)]);
  await tab.addHandle([0], 'Tip');
  expect(tab.app.state.viewing.value).toBeNull();
  await files.openFiles([file('wig.obj', LINES)]);
  await commands.run('edit.cancel');
  expect(tab.app.state.viewing.value).toBeNull();
  expect(state.selection.value.item).toBe(0);
  expect(corners(shown.model)).toBe(8);
});

test('an OBJ of faces and lines opens as a model, and its lines can be looked at on it', async () => {
  const { tab, shown } = await looking();
  const { state, files, document } = tab.app;
  await files.openFiles([file('groom.obj', WITH_HEAD)]);
  await tab.app.evaluator.settled();
  expect(document.recipe.models).toEqual({ groom: { file: 'groom.obj' } });
  expect(tab.app.state.viewing.value).toBeNull();
  const { action } = state.toasts.value.find(({ text }) => text.includes('lines'))!;
  await action!.run();
  expect(tab.app.state.viewing.value).toMatchObject({ on: 'own-head' });
  expect([corners(shown.model), shown.strands]).toEqual([8, 2]);
});

test('lines that are no strands do not keep a model from opening', async () => {
  const { tab } = await looking();
  await tab.app.files.openFiles([file('loose.obj', `${CUBE_OBJ}\nl 3\nl 1 99\n`)]);
  await tab.app.evaluator.settled();
  expect(tab.app.document.recipe.models).toEqual({ loose: { file: 'loose.obj' } });
  expect(tab.app.state.viewing.value).toBeNull();
});

test('a damaged .hair file is refused by name, and nothing changes', async () => {
  const { tab } = await looking();
  const { recipe } = tab.app.document;
  await tab.app.files.openFiles([file('wig.hair', 'HAIR and not much more')]);
  await tab.app.files.openFiles([file('letter.hair', 'Dear reader,')]);
  expect(tab.app.state.viewing.value).toBeNull();
  expect(tab.app.document.recipe).toBe(recipe);
  expect(tab.toasts).toHaveLength(2);
  expect(tab.toasts[0]).toContain('wig.hair');
  expect(tab.toasts[1]).toContain('letter.hair');
});
