import { expect, test, vi } from 'vitest';
import { NewestWork } from '../../web/app/newest-work';

test('the newest work alone goes on, and what goes wrong is told', async () => {
  const failed = vi.fn();
  const work = new NewestWork({ failed });
  const signals: AbortSignal[] = [];
  const begin = (end: Promise<void>) =>
    work.start((signal) => {
      signals.push(signal);
      return end;
    });
  begin(Promise.resolve());
  begin(Promise.reject(new Error('lost')));
  await Promise.resolve();
  expect(signals.map(({ aborted }) => aborted)).toEqual([true, false]);
  work.end();
  expect(signals[1]!.aborted).toBe(true);
  await vi.waitFor(() => expect(failed).toHaveBeenCalledExactlyOnceWith(new Error('lost')));
});
