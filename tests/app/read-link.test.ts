import { afterEach, expect, test, vi } from 'vitest';
import { answerLink, type LinkWorker, readLink } from '../../web/app/read-link';
import { LissomError } from '../../web/core/errors';
import { encodeLink } from '../../web/recipe/link/link';
import { parseRecipe } from '../../web/recipe/parse';

const recipe = parseRecipe({ lissom: 1, models: { m: { builtin: 'bar' } }, steps: [] });
const link = encodeLink(recipe);

/** A worker that answers as the real one does, after being cloned on the way, or never. */
class Fake implements LinkWorker {
  onmessage: LinkWorker['onmessage'] = null;
  onerror: LinkWorker['onerror'] = null;
  ended = false;

  constructor(private readonly behaviour: 'answers' | 'is silent' | 'fails') {}

  postMessage(given: string): void {
    if (this.behaviour === 'is silent') return;
    queueMicrotask(() => {
      if (this.behaviour === 'fails') this.onerror?.({ preventDefault() {} } as ErrorEvent);
      else this.onmessage?.({ data: structuredClone(answerLink(given)) } as MessageEvent);
    });
  }
  terminate(): void {
    this.ended = true;
  }
}

afterEach(() => vi.useRealTimers());

test('a link is read by the worker, which then ends', async () => {
  const worker = new Fake('answers');
  expect(await readLink(link, () => worker)).toEqual(recipe);
  expect(worker.ended).toBe(true);
});

test('a refusal comes back as the error it was', async () => {
  const failure = readLink(link.slice(0, 30), () => new Fake('answers'));
  await expect(failure).rejects.toBeInstanceOf(LissomError);
  await expect(failure).rejects.toMatchObject({ code: 'link-cut', fault: 'input' });
});

test('a worker that takes too long is ended, and the link refused in words', async () => {
  vi.useFakeTimers();
  const worker = new Fake('is silent');
  const reading = readLink(link, () => worker);
  const refused = expect(reading).rejects.toThrow(
    'The link was not read within 5 seconds, so it was not opened. Ask for a project file instead.',
  );
  await vi.advanceTimersByTimeAsync(5000);
  await refused;
  expect(worker.ended).toBe(true);
});

test('without a worker the link is read here', async () => {
  const none = () => {
    throw new Error('no workers');
  };
  expect(await readLink(link, none)).toEqual(recipe);
  expect(await readLink(link, () => new Fake('fails'))).toEqual(recipe);
});
