// Reading a link aside from the page, within a time: a link comes from anyone.

import { type Fault, LissomError } from '../core/errors';
import { linkTooSlow } from '../recipe/link/errors';
import { decodeLink } from '../recipe/link/link';
import type { Recipe } from '../recipe/recipe';

/** How long a link may take, in seconds; the largest that can be made takes a tenth of it on a phone. */
const DEADLINE = 5;

export type LinkAnswer =
  | { readonly recipe: Recipe }
  | { readonly code: string; readonly message: string; readonly fault: Fault };

/** What a Worker and a test's stand-in have in common. */
export interface LinkWorker {
  postMessage(link: string): void;
  terminate(): void;
  onmessage: ((event: MessageEvent<LinkAnswer>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
}

const startWorker = (): LinkWorker =>
  new Worker(new URL('./link-worker.ts', import.meta.url), { type: 'module' }) as unknown as LinkWorker;

/**
 * The recipe of a link, read by a worker that is ended after the deadline. Where there is none to be had it is read
 * here: what a link may take is bounded by `decodeLink` itself.
 *
 * @throws LissomError  what `decodeLink` says; `link-too-slow`
 */
export async function readLink(link: string, start: () => LinkWorker = startWorker): Promise<Recipe> {
  const answer = await answerOf(link, start);
  if (answer === null) return decodeLink(link);
  if ('recipe' in answer) return answer.recipe;
  throw new LissomError(answer.code, answer.message, answer.fault);
}

/** The worker's end. */
export function answerLink(link: string): LinkAnswer {
  try {
    return { recipe: decodeLink(link) };
  } catch (error) {
    if (error instanceof LissomError) return { code: error.code, message: error.message, fault: error.fault };
    throw error;
  }
}

/** @returns `null` where no worker could be started */
function answerOf(link: string, start: () => LinkWorker): Promise<LinkAnswer | null> {
  let worker: LinkWorker;
  try {
    worker = start();
  } catch {
    return Promise.resolve(null);
  }
  return new Promise<LinkAnswer | null>((resolve, reject) => {
    const late = setTimeout(() => end(() => reject(linkTooSlow(DEADLINE))), 1000 * DEADLINE);
    const end = (settle: () => void) => {
      clearTimeout(late);
      worker.terminate();
      settle();
    };
    worker.onmessage = ({ data }) => end(() => resolve(data));
    worker.onerror = (event) => {
      event.preventDefault();
      end(() => resolve(null));
    };
    worker.postMessage(link);
  });
}
