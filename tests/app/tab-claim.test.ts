import { expect, test, vi } from 'vitest';
import { ANSWER_TIME, ChannelClaims } from '../../web/app/tab-claim';

type Channel = Pick<BroadcastChannel, 'postMessage' | 'onmessage'>;

/** What tabs say reaches all others, later; a sleeping tab hears it when it wakes. */
class Air {
  readonly #tabs = new Map<string, { channel: Channel; asleep: MessageEvent[] | null }>();

  tab(name: string): ChannelClaims {
    const channel: Channel = {
      onmessage: null,
      postMessage: (data: unknown) => {
        const event = { data: structuredClone(data) } as MessageEvent;
        for (const [each, { channel, asleep }] of this.#tabs)
          if (each === name) continue;
          else if (asleep) asleep.push(event);
          else queueMicrotask(() => channel.onmessage?.call(null as never, event));
      },
    };
    this.#tabs.set(name, { channel, asleep: null });
    return new ChannelClaims(channel, name);
  }

  sleep(name: string): void {
    this.#tabs.get(name)!.asleep = [];
  }

  wake(name: string): void {
    const tab = this.#tabs.get(name)!;
    const heard = tab.asleep ?? [];
    tab.asleep = null;
    for (const event of heard) tab.channel.onmessage?.call(null as never, event);
  }

  crash(name: string): void {
    this.#tabs.delete(name);
  }
}

test('a document belongs to one tab until it is released, or the tab is gone', async () => {
  const air = new Air();
  const [a, b] = [air.tab('a'), air.tab('b')];
  expect(await a.claim('work')).toBe(true);
  expect(await a.claim('work')).toBe(true);
  expect(await b.claim('work')).toBe(false);
  expect(await b.claim('other')).toBe(true);
  a.release('work');
  expect(await b.claim('work')).toBe(true);
  air.crash('b');
  expect(await a.claim('work')).toBe(true);
});

test('of tabs that ask at the same time exactly one has it', async () => {
  for (const names of [
    ['a', 'b', 'c'],
    ['c', 'b', 'a'],
    ['b', 'c', 'a'],
  ]) {
    const air = new Air();
    const tabs = names.map((name) => air.tab(name));
    const answers = await Promise.all(tabs.map((tab) => tab.claim('work')));
    expect(answers.filter((answer) => answer)).toHaveLength(1);
  }
});

test('a tab that slept while it was asked keeps what it had; whoever took it hears of that', async () => {
  const air = new Air();
  const [a, b] = [air.tab('a'), air.tab('b')];
  const lost = { a: vi.fn(), b: vi.fn() };
  a.onLost(lost.a);
  b.onLost(lost.b);
  await a.claim('work');
  air.sleep('a');
  expect(await b.claim('work')).toBe(true);
  air.wake('a');
  await vi.waitFor(() => expect(lost.b).toHaveBeenCalledExactlyOnceWith('work'));
  expect(lost.a).not.toHaveBeenCalled();
  expect(await b.claim('work')).toBe(false);
});

test('who only looks is never in the way of who claims', async () => {
  const air = new Air();
  const [a, b] = [air.tab('a'), air.tab('b')];
  const [seen, claimed] = await Promise.all([a.isFree('work'), b.claim('work')]);
  expect([seen, claimed]).toEqual([true, true]);
  expect(await a.isFree('work')).toBe(false);
  expect(await b.isFree('work')).toBe(true);
  b.release('work');
  expect(await a.isFree('work')).toBe(true);
  expect(await b.claim('work')).toBe(true);
});

test('an answer takes no longer than it has to', async () => {
  const air = new Air();
  const [a, b] = [air.tab('a'), air.tab('b')];
  await a.claim('work');
  const started = performance.now();
  await b.claim('work');
  expect(performance.now() - started).toBeLessThan(ANSWER_TIME);
});
