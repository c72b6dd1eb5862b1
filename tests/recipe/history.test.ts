import { expect, test, vi } from 'vitest';
import { History } from '../../web/recipe/history';

const doc = (name: string) => ({ name });
const [blank, moved, turned] = [doc('blank'), doc('moved'), doc('turned')];

function fresh() {
  const clock = { time: 0 };
  return { clock, history: new History(blank, 'nothing', 'Open', () => clock.time) };
}

test('undo and redo return the very same documents and stop at the ends', () => {
  const { history } = fresh();
  history.commit('Move', moved);
  history.undo();
  history.undo();
  expect(history.document).toBe(blank);
  history.redo();
  history.redo();
  expect(history.document).toBe(moved);
});

test('undo has no limit', () => {
  const { history } = fresh();
  const documents = Array.from({ length: 5000 }, (_, i) => doc(`${i}`));
  for (const each of documents) history.commit('Edit', each);
  for (const each of documents.toReversed()) {
    expect(history.document).toBe(each);
    history.undo();
  }
  expect(history.document).toBe(blank);
  expect(history.canUndo).toBe(false);
});

test('an edit after undo takes the place of what was undone', () => {
  const { history } = fresh();
  history.commit('Move', moved);
  history.undo();
  history.commit('Turn', turned);
  expect(history.canRedo).toBe(false);
  expect(history.entries.map(({ label }) => label)).toEqual(['Open', 'Turn']);
});

test('dirty means different from what was saved, not a count of steps', () => {
  const { history } = fresh();
  history.commit('Move', moved);
  history.markSaved();
  expect(history.isDirty).toBe(false);
  history.undo();
  expect(history.isDirty).toBe(true);
  history.commit('Other move', doc('moved'));
  expect(history.isDirty).toBe(true);
});

test('a save that finishes after another edit leaves the document dirty', () => {
  const { history } = fresh();
  history.commit('Move', moved);
  history.commit('Turn', turned);
  history.markSaved(moved);
  expect(history.isDirty).toBe(true);
});

test('a selection can be undone and makes nothing dirty', () => {
  const { history } = fresh();
  history.commit('Select', blank, 'handle 1');
  expect([history.isDirty, history.canUndo, history.selection]).toEqual([false, true, 'handle 1']);
  history.undo();
  expect(history.selection).toBe('nothing');
});

test('a gesture is drawn as it goes and becomes one entry', () => {
  const { history } = fresh();
  history.begin('Move');
  history.preview(doc('half way'));
  history.preview(moved, 'handle 1');
  expect([history.shown, history.document, history.selection]).toEqual([moved, blank, 'handle 1']);
  history.finish();
  expect([history.shown, history.document, history.undoLabel]).toEqual([moved, moved, 'Move']);
  expect(history.entries).toHaveLength(2);
});

test('a cancelled gesture leaves no trace', () => {
  const { history } = fresh();
  history.commit('Move', moved);
  history.undo();
  const before = [history.entries, history.index, history.selection];
  history.begin('Turn');
  history.preview(turned, 'handle 1');
  history.cancel();
  expect([history.entries, history.index, history.selection]).toEqual(before);
  expect([history.shown, history.canRedo, history.isPreviewing]).toEqual([blank, true, false]);
});

test('a gesture that previewed nothing adds nothing', () => {
  const { history } = fresh();
  history.begin('Move');
  history.finish();
  history.commit('Nothing new', blank);
  expect(history.entries).toHaveLength(1);
});

test('numbers typed in quick succession are one entry, until a pause, a save, an undo or another field', () => {
  const { history, clock } = fresh();
  const type = (name: string, series: string, after = 100) => {
    clock.time += after;
    history.commit(`Set ${series}`, doc(name), history.selection, { series });
    return history.entries.length - 1;
  };
  expect(type('1', 'x')).toBe(1);
  expect(type('12', 'x')).toBe(1);
  expect(type('12 5', 'y')).toBe(2);
  expect(type('12 50', 'y', 5000)).toBe(3);
  history.markSaved();
  expect(type('12 500', 'y')).toBe(4);
  history.undo();
  expect(type('12 7', 'y')).toBe(4);
  history.undo();
  expect(history.document).toEqual(doc('12 50'));
});

test('the list of entries can be jumped through', () => {
  const { history } = fresh();
  history.commit('Move', moved);
  history.commit('Turn', turned);
  history.jump(0);
  expect([history.document, history.redoLabel]).toEqual([blank, 'Move']);
  history.jump(2);
  expect([history.document, history.redoLabel]).toEqual([turned, undefined]);
});

test('listeners hear of every change until they unsubscribe, even from within', () => {
  const { history } = fresh();
  const heard = vi.fn();
  const stop = history.subscribe(() => {
    heard();
    if (heard.mock.calls.length === 3) stop();
  });
  history.preview(moved);
  history.commit('Move', moved);
  history.undo();
  history.redo();
  expect(heard).toHaveBeenCalledTimes(3);
});
