// The store on a real implementation of IndexedDB: its transactions, its versions, its connections.

import { IDBFactory, IDBKeyRange } from 'fake-indexeddb';
import { beforeEach, expect, test, vi } from 'vitest';
import { BrowserStore, hashesOf, type StoredDocument } from '../../web/app/store';

beforeEach(async () => {
  for (const [name, value] of Object.entries(await import('fake-indexeddb')))
    if (name.startsWith('IDB')) vi.stubGlobal(name, value);
  vi.stubGlobal('indexedDB', new IDBFactory());
  vi.stubGlobal('IDBKeyRange', IDBKeyRange);
});

const bytes = (...values: number[]) => Uint8Array.from(values);

const document = (id: string, ...hashes: string[]): StoredDocument => ({
  id,
  time: 1,
  title: id,
  kind: 'auto',
  entries: hashes.map((recipe) => ({
    recipe,
    selection: { step: '', handle: null },
    label: recipe,
    time: 1,
  })),
  index: hashes.length - 1,
  files: [],
  steps: 0,
  handles: 0,
});

const blobs = (...hashes: string[]) => new Map(hashes.map((hash, i) => [hash, bytes(i)]));

/** Another tab, which asks for nothing of this program's. */
const opened = (version?: number) =>
  new Promise<IDBDatabase>((resolve, reject) => {
    const request = indexedDB.open('lissom', version);
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });

const deleted = () =>
  new Promise<void>((resolve, reject) => {
    const request = indexedDB.deleteDatabase('lissom');
    request.onsuccess = () => resolve();
    request.onerror = () => reject(request.error);
  });

/** How long the other tab waits before it begins: the two interleave differently with each. */
const waits = Array.from({ length: 40 }, (_, i) => i);

test('a document is never without its blobs, whatever another tab removes meanwhile', async () => {
  for (const turns of waits) {
    vi.stubGlobal('indexedDB', new IDBFactory());
    const [one, other] = [new BrowserStore(), new BrowserStore()];
    await one.write(document('old', 'shared'), blobs('shared'));
    await other.documents();
    const removing = (async () => {
      for (let i = 0; i < turns; i++) await new Promise(setImmediate);
      await other.remove(['old']);
    })();
    await Promise.all([one.write(document('new', 'shared', 'own'), blobs('shared', 'own')), removing]);
    const documents = await one.documents();
    expect(documents.map(({ id }) => id)).toEqual(['new']);
    for (const hash of documents.flatMap(hashesOf))
      expect(await one.blob(hash), `${hash} after ${turns} turns`).toBeDefined();
  }
});

test('blobs that are kept are not written again; those that nobody names any more go', async () => {
  const store = new BrowserStore();
  await store.write(document('a', 'x', 'y'), new Map(Object.entries({ x: bytes(1), y: bytes(2) })));
  await store.write(document('b', 'x'), new Map(Object.entries({ x: bytes(9) })));
  expect(await store.blob('x')).toEqual(bytes(1));
  await store.remove(['a']);
  expect(await store.blob('x')).toEqual(bytes(1));
  expect(await store.blob('y')).toBeUndefined();
});

test('what is refused before it is written takes the rest with it', async () => {
  const store = new BrowserStore();
  await store.write(document('a', 'x'), blobs('x'));
  const unhandled = vi.fn();
  process.on('unhandledRejection', unhandled);
  const { put } = IDBObjectStore.prototype;
  for (const refused of ['blobs', 'documents']) {
    const refusing = vi.spyOn(IDBObjectStore.prototype, 'put').mockImplementation(function (
      this: IDBObjectStore,
      ...args
    ) {
      if (this.name === refused) throw new DOMException('out of memory', 'DataCloneError');
      return put.apply(this, args);
    });
    await expect(store.write(document('a', 'x', 'y'), blobs('x', 'y'))).rejects.toThrow('out of memory');
    refusing.mockRestore();
    expect((await store.document('a'))?.entries, refused).toHaveLength(1);
    expect(await store.blob('y'), refused).toBeUndefined();
  }
  await new Promise((done) => setTimeout(done, 20));
  process.off('unhandledRejection', unhandled);
  expect(unhandled).not.toHaveBeenCalled();
  await store.write(document('a', 'x', 'y'), blobs('x', 'y'));
  expect((await store.document('a'))?.entries).toHaveLength(2);
});

test('what is only to be written where it is newer leaves the rest alone', async () => {
  const store = new BrowserStore();
  const at = (revision: number, ...hashes: string[]) => ({ ...document('a', ...hashes), revision });
  await store.write(at(3, 'x'), blobs('x'), true);
  await store.write(at(3, 'x', 'y'), blobs('x', 'y'), true);
  await store.write(at(2, 'x', 'y'), blobs('x', 'y'), true);
  expect((await store.document('a'))?.entries).toHaveLength(1);
  expect(await store.blob('y')).toBeUndefined();
  await store.write(at(4, 'x', 'y'), blobs('x', 'y'), true);
  expect((await store.document('a'))?.revision).toBe(4);
});

test('a database that another tab closed by deleting it is opened again', async () => {
  const store = new BrowserStore();
  await store.write(document('a', 'x'), blobs('x'));
  await deleted();
  expect(await store.documents()).toEqual([]);
  await store.write(document('b', 'x'), blobs('x'));
  expect(await store.blob('x')).toBeDefined();
});

test('a newer version in another tab is not kept waiting; with it gone the store works again', async () => {
  const store = new BrowserStore();
  await store.write(document('a', 'x'), blobs('x'));
  const newer = await opened(2);
  await expect(store.documents()).rejects.toThrow(/version/);
  newer.close();
  await deleted();
  await store.write(document('b', 'x'), blobs('x'));
  expect((await store.documents()).map(({ id }) => id)).toEqual(['b']);
});

test('a connection that was closed without a word is noticed and opened anew', async () => {
  const store = new BrowserStore();
  const databases: IDBDatabase[] = [];
  const open = indexedDB.open.bind(indexedDB);
  vi.spyOn(indexedDB, 'open').mockImplementation((...args) => {
    const request = open(...args);
    request.addEventListener('success', () => databases.push(request.result));
    return request;
  });
  await store.write(document('a', 'x'), blobs('x'));
  databases[0]!.close();
  expect((await store.documents()).map(({ id }) => id)).toEqual(['a']);
  expect(databases).toHaveLength(2);
});

test('an opening that is refused is tried again', async () => {
  const store = new BrowserStore();
  const refusing = vi.spyOn(indexedDB, 'open').mockImplementation(() => {
    throw new DOMException('storage is off', 'SecurityError');
  });
  await expect(store.documents()).rejects.toThrow('storage is off');
  refusing.mockRestore();
  expect(await store.documents()).toEqual([]);
});

test('a database that never answers is given up, with a sentence', async () => {
  const held = await opened(1);
  const waiting = opened(2); // until the first is closed, and whoever comes later waits behind it
  const store = new BrowserStore();
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
  const asked = expect(store.documents()).rejects.toThrow(/does not answer/);
  await vi.advanceTimersByTimeAsync(5000);
  await asked;
  vi.useRealTimers();
  held.close();
  (await waiting).close();
});
