import { expect, test } from 'vitest';
import { Latest } from '../../web/core/latest';

function setUp() {
  const waiting: {
    input: number;
    signal: AbortSignal;
    resolve: (n: number) => void;
    reject: (e: unknown) => void;
  }[] = [];
  const shown: number[] = [];
  const failed: unknown[] = [];
  const latest = new Latest<number, number>({
    work: (input, signal) =>
      new Promise((resolve, reject) => waiting.push({ input, signal, resolve, reject })),
    deliver: (output) => void shown.push(output),
    fail: (error) => void failed.push(error),
  });
  const turn = async () => {
    for (let i = 0; i < 5; i++) await Promise.resolve();
  };
  return { latest, waiting, shown, failed, turn };
}

test('one call is in flight, and of those waiting only the newest follows', async () => {
  const { latest, waiting, shown, turn } = setUp();
  latest.push(1);
  await turn();
  for (const n of [2, 3, 4]) latest.push(n);
  await turn();
  expect(waiting.map(({ input }) => input)).toEqual([1]);
  waiting[0]!.resolve(10);
  await turn();
  expect(waiting.map(({ input }) => input)).toEqual([1, 4]);
  waiting[1]!.resolve(40);
  await latest.settled();
  expect(shown).toEqual([10, 40]);
  expect(latest.busy).toBe(false);
});

test('after cancel the call in flight is aborted and its late answer dropped', async () => {
  const { latest, waiting, shown, failed, turn } = setUp();
  latest.push(1);
  await turn();
  latest.push(2);
  latest.cancel();
  expect(waiting[0]!.signal.aborted).toBe(true);
  latest.push(3);
  waiting[0]!.resolve(10);
  await turn();
  expect(waiting.map(({ input }) => input)).toEqual([1, 3]);
  waiting[1]!.resolve(30);
  await latest.settled();
  expect([shown, failed]).toEqual([[30], []]);
});

test('a failure is told and does not stop what comes after', async () => {
  const { latest, waiting, shown, failed, turn } = setUp();
  latest.push(1);
  await turn();
  latest.push(2);
  waiting[0]!.reject('no');
  await turn();
  waiting[1]!.resolve(20);
  await latest.settled();
  expect([shown, failed]).toEqual([[20], ['no']]);
});

test('settled resolves at once when nothing is under way', async () => {
  await setUp().latest.settled();
});
