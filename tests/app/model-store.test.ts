import { beforeEach, expect, test, vi } from 'vitest';
import { ModelStore } from '../../web/app/model-store';
import { readModel } from '../../web/io/formats';
import { readObj } from '../../web/io/obj-read';
import { CUBE_OBJ, file, Tab } from './world';

vi.mock('../../web/io/formats', { spy: true });
vi.mock('../../web/io/obj-read', { spy: true });

const bytes = (text: string) => new TextEncoder().encode(text);
/** A cube with a strand on it. */
const WITH_LINES = `${CUBE_OBJ}\nv 0 0 2\nv 0 0 3\nl 9 10`;

beforeEach(() => {
  vi.mocked(readModel).mockClear();
  vi.mocked(readObj).mockClear();
});

const empty = () => new ModelStore(async () => Promise.reject(new Error('there is no gallery')));

test.each([
  ['a mesh', CUBE_OBJ],
  ['a mesh with lines', WITH_LINES],
])('%s that is opened and shown was read once', async (_, text) => {
  const tab = new Tab();
  await tab.app.files.openFiles([file('cube.obj', text)]);
  await tab.app.evaluator.settled();
  expect(tab.app.state.importReport.value).toMatchObject({ file: 'cube.obj' });
  expect(readModel).toHaveBeenCalledTimes(1);
  expect(readObj).toHaveBeenCalledTimes(1);
});

test('a file that cannot be read is not kept', async () => {
  const models = empty();
  await expect(models.open('cube.obj', bytes('# nothing in it'))).rejects.toThrow(/cube\.obj/);
  expect(models.get('cube.obj')).toBeUndefined();
});

test('another mesh of the same name is kept, and called, by a name of its own', async () => {
  const models = empty();
  const first = await models.open('cube.obj', bytes(CUBE_OBJ));
  const other = await models.open('cube.obj', bytes(CUBE_OBJ.replaceAll(' 1\n', ' 9\n')));
  expect([first.file, other.file]).toEqual(['cube.obj', 'cube 2.obj']);
  expect([first.model.name, other.model.name]).toEqual(['cube.obj', 'cube 2.obj']);
  expect((await models.read({ file: 'cube 2.obj' })).model).toBe(other.model);
  expect((await models.open('cube.obj', bytes(CUBE_OBJ))).model).toBe(first.model);
});
