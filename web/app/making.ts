// Making a built-in model that no file holds, aside from the page: it takes a second or more, and can be cancelled.

import { cancelled, LissomError } from '../core/errors';
import type { Model } from '../core/model';
import { type BuiltIn, builtInAtOnce, builtInModel } from '../io/built-in';
import type { ReadResult } from '../io/reading';

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

/** What a Worker and a test's stand-in have in common. */
export interface MakingWorker {
  postMessage(order: MakingOrder): void;
  terminate(): void;
  onmessage: ((event: MessageEvent<MakingReply>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
}

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
  options: MakingOptions,
  start: () => MakingWorker = startWorker,
): Promise<ReadResult> {
  const made = await answerOf(order, options, start);
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

/** @returns `null` where no worker could be started */
function answerOf(
  order: MakingOrder,
  { signal, onProgress }: MakingOptions,
  start: () => MakingWorker,
): Promise<ReadResult | null> {
  if (signal.aborted) return Promise.reject(cancelled());
  let worker: MakingWorker;
  try {
    worker = start();
  } catch {
    return Promise.resolve(null);
  }
  return new Promise<ReadResult | null>((resolve, reject) => {
    const end = (settle: () => void) => {
      signal.removeEventListener('abort', stop);
      worker.terminate();
      settle();
    };
    const stop = () => end(() => reject(cancelled()));
    signal.addEventListener('abort', stop);
    worker.onmessage = ({ data }) => {
      if ('progress' in data) onProgress(data.progress);
      else if ('made' in data) end(() => resolve(data.made));
      else {
        const { code, message, fault } = data.failed;
        end(() => reject(new LissomError(code, message, fault)));
      }
    };
    worker.onerror = (event) => {
      event.preventDefault();
      end(() => resolve(null));
    };
    worker.postMessage(order);
  });
}
