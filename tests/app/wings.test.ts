import { expect, test } from 'vitest';
import { Tab } from './world';

test('a wing is loaded when its workspace is first entered, and only once', async () => {
  const tab = new Tab();
  const { wings, commands } = tab.app;
  await tab.openCube();
  expect([...wings.loaded.value.keys()]).toEqual(['deform']);
  await commands.run('workspace.merge');
  const merge = wings.get('merge');
  expect([...wings.loaded.value.keys()]).toEqual(['deform', 'merge']);
  await commands.run('workspace.deform');
  await commands.run('workspace.merge');
  expect(wings.get('merge')).toBe(merge);
});

test('commands of a wing join the others with it, in the order of the registry', async () => {
  const { wings, commands } = new Tab().app;
  await wings.load('merge');
  expect(commands.all.some(({ id }) => id === 'hair.delete')).toBe(false);
  await wings.loadAll();
  const ids = commands.all.map(({ id }) => id);
  const order = ['handle.new', 'hair.delete', 'merge.run', 'view.fit'].map((id) => ids.indexOf(id));
  expect(order).toEqual([...order].sort((a, b) => a - b));
  expect(order).not.toContain(-1);
});
