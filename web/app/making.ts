// Making a built-in model that no file holds, aside from the page: it takes a second or more, and can be cancelled.

import { cancelled, LissomError } from '../core/errors';
import type { Model } from '../core/model';
import { type BuiltIn, builtInAtOnce, builtInModel } from '../io/built-in';
import type { ReadResult } from '../io/reading';
import { type AsideWorker, askAside } from './ask-aside';

/** What the worker is given. */
export interface MakingOrder {
  readonly entry: BuiltIn;
  /** Of the file that it is made of. */
  readonly bytes: Uint8Array;
}

export type MakingReply =
  | { readonly progress: number }
  | { readonly made: ReadResult }
  | { readonly failed: Pick<LissomError, 'code' | 'message' | 'fault'> };

export type MakingWorker = AsideWorker<MakingOrder, MakingReply>;

export interface MakingOptions {
  readonly signal: AbortSignal;
  /** @param fraction  in [0, 1] */
  readonly onProgress: (fraction: number) => void;
}

const startWorker = (): MakingWorker =>
  new Worker(new URL('./making-worker.ts', import.meta.url), { type: 'module' }) as unknown as MakingWorker;

/**
 * The model, made by a worker of its own that ends with it; here where none can be started.
 *
 * @throws LissomError  what the reader says of the file; `cancelled`
 */
export async function madeAside(
  order: MakingOrder,
  { signal, onProgress }: MakingOptions,
  start: () => MakingWorker = startWorker,
): Promise<ReadResult> {
  if (signal.aborted) throw cancelled();
  const made = await askAside(start, order, {
    hear: (reply: MakingReply) => {
      if ('made' in reply) return reply.made;
      if ('failed' in reply)
        throw new LissomError(reply.failed.code, reply.failed.message, reply.failed.fault);
      onProgress(reply.progress);
      return undefined;
    },
    watch: (giveUp) => {
      const stop = () => giveUp(cancelled());
      signal.addEventListener('abort', stop);
      return () => signal.removeEventListener('abort', stop);
    },
  });
  return made ?? builtInAtOnce(order.entry, order.bytes);
}

/** The worker's end. @param reply  sends an answer; `moved` goes over instead of being copied */
export function make(
  { entry, bytes }: MakingOrder,
  reply: (reply: MakingReply, moved: Transferable[]) => void,
) {
  try {
    const making = builtInModel(entry, bytes);
    for (;;) {
      const { done, value } = making.next();
      if (done) return reply({ made: value }, buffersOf(value.model));
      reply({ progress: value }, []);
    }
  } catch (error) {
    if (!(error instanceof LissomError)) throw error;
    const { code, message, fault } = error;
    reply({ failed: { code, message, fault } }, []);
  }
}

const buffersOf = ({ positions, faceOffsets, faceVertices }: Model): Transferable[] => [
  ...new Set([positions, faceOffsets, faceVertices].map(({ buffer }) => buffer as ArrayBuffer)),
];
