// Reading a link aside from the page, within a time: a link comes from anyone.

import { type Fault, LissomError } from '../core/errors';
import { linkTooSlow } from '../recipe/link/errors';
import { decodeLink } from '../recipe/link/link';
import type { Recipe } from '../recipe/recipe';
import { type AsideWorker, askAside } from './ask-aside';

/** How long a link may take, in seconds; the largest that can be made takes a tenth of it on a phone. */
const DEADLINE = 5;

export type LinkAnswer =
  | { readonly recipe: Recipe }
  | { readonly code: string; readonly message: string; readonly fault: Fault };

export type LinkWorker = AsideWorker<string, LinkAnswer>;

const startWorker = (): LinkWorker =>
  new Worker(new URL('./link-worker.ts', import.meta.url), { type: 'module' }) as unknown as LinkWorker;

/**
 * The recipe of a link, read by a worker that is ended after the deadline. Where there is none to be had it is read
 * here: what a link may take is bounded by `decodeLink` itself.
 *
 * @throws LissomError  what `decodeLink` says; `link-too-slow`
 */
export async function readLink(link: string, start: () => LinkWorker = startWorker): Promise<Recipe> {
  const answer = await askAside(start, link, {
    hear: (heard: LinkAnswer) => heard,
    watch: (giveUp) => {
      const late = setTimeout(() => giveUp(linkTooSlow(DEADLINE)), 1000 * DEADLINE);
      return () => clearTimeout(late);
    },
  });
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
