// A transfer through a match in its workspace, on a kernel of few lines: nothing is paired, and nothing asks to be.

import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { IDENTITY } from '../../web/core/affine';
import { parseRecipe } from '../../web/recipe/parse';
import { pointAt } from '../../web/tools/geometry';
import { matchedRecipe, settled, stubGallery } from './matched';
import { Tab } from './world';

beforeEach(stubGallery);
afterEach(() => vi.unstubAllGlobals());

const deform = (id: string, model: string, x: number) => ({
  id,
  type: 'deform',
  model,
  handles: [
    { kind: 'region', vertices: [7], matrix: [...IDENTITY.slice(0, 12), x, 0, 0, 1] },
    { kind: 'region', vertices: [0, 1], matrix: IDENTITY },
  ],
});
const give = { id: 'give', type: 'transfer', model: 'bob', like: 'pose', through: 'match 1' };

async function opened(step: object = give): Promise<Tab> {
  const tab = new Tab();
  const { steps, ...rest } = matchedRecipe();
  const models = { ...rest.models, coat: { builtin: 'coat' } };
  const poses = [deform('pose', 'ann', 2), deform('other', 'cid', 5), deform('coat pose', 'coat', 1)];
  const recipe = parseRecipe({ ...rest, models, steps: [...steps, ...poses, step] });
  await tab.app.desk.open({ recipe, title: 'through' });
  await settled(tab);
  return tab;
}

const shown = (tab: Tab) => tab.app.evaluator.result.value!;

test('it opens with the pose given, both models on screen and nothing to pair', async () => {
  const tab = await opened();
  expect(tab.app.state.workspace.value).toBe('transfer');
  expect(tab.toasts).toEqual([]);
  expect(tab.transferState.problem.value).toBeNull();
  expect(pointAt(shown(tab).positions, 7)[0]).toBe(pointAt(shown(tab).shown.model.positions, 7)[0]! + 2);
  expect(tab.transferState.source.value).toMatchObject({ id: 'pose', handles: [] });
  expect(tab.transferState.figures.value).toMatchObject({ unknowns: 8, iterations: 1, prepare: 2 });
  expect(tab.transfer.rows()).toEqual([]);
  expect(tab.transfer.open()).toEqual([]);
  expect(tab.app.state.status.value).toContain('nothing need be paired');
  expect(tab.app.commands.isEnabled('transfer.next')).toBe(false);
  expect(tab.app.commands.isEnabled('transfer.edit-pose')).toBe(true);
});

test('its strength is changed as that of any other', async () => {
  const tab = await opened();
  tab.transfer.setStrength(0.5);
  await settled(tab);
  expect(pointAt(shown(tab).positions, 7)[0]).toBe(pointAt(shown(tab).shown.model.positions, 7)[0]! + 1);
});

test("poses of the match's models may be given instead", async () => {
  const tab = await opened();
  expect(tab.transfer.poses().map(({ id }) => id)).toEqual(['pose', 'other']);
  tab.transfer.choosePose('other');
  await settled(tab);
  expect(tab.transferState.step.value).toMatchObject({ like: 'other', through: 'match 1', handles: [] });
  expect(pointAt(shown(tab).positions, 7)[0]).toBe(pointAt(shown(tab).shown.model.positions, 7)[0]! + 5);
});
