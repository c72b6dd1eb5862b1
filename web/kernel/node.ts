// The kernel inside Node, for the command line and the tests: same handlers, no worker.

import { existsSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { cancelled, LissomError } from '../core/errors';
import type { Args, CallOptions, KernelPort, Method, Result } from './contract';
import { failureOf, toError } from './failures';
import { createHandlers } from './handlers/all';
import { Job } from './job';
import { instantiate } from './module';
import type { Handlers } from './serve';

/** Beside the bundled command line, or where scripts/wasm.mjs leaves it. */
const PLACES = ['./kernel.wasm', '../../wasm/dist/kernel.wasm'];

class NodeKernel implements KernelPort {
  #epoch = 0;
  #handlers: Promise<Handlers> | null = null;

  constructor(private readonly compiled: WebAssembly.Module) {}

  get epoch(): number {
    return this.#epoch;
  }

  async call<M extends Method>(method: M, args: Args<M>, options: CallOptions = {}): Promise<Result<M>> {
    const { signal = new AbortController().signal, onProgress, onLook } = options;
    const epoch = this.#epoch;
    try {
      this.#handlers ??= instantiate(this.compiled).then((wasm) => createHandlers(wasm, epoch));
      const handlers = await this.#handlers;
      if (signal.aborted) throw cancelled();
      const job = new Job(signal, (fraction) => onProgress?.(fraction), undefined, onLook);
      return await handlers[method](args, job);
    } catch (thrown) {
      const failure = failureOf(thrown);
      if (failure.fatal && epoch === this.#epoch) {
        this.#epoch++;
        this.#handlers = null;
      }
      throw toError(failure);
    }
  }
}

/**
 * @param place  kernel.wasm, if it is not in its usual places
 * @throws LissomError `kernel-not-found`
 */
export async function loadKernel(place?: string | URL): Promise<KernelPort> {
  return new NodeKernel(await compileKernel(place));
}

/** As `loadKernel`, for those who make its instances themselves. */
export async function compileKernel(place?: string | URL): Promise<WebAssembly.Module> {
  const found = place ?? PLACES.map((path) => new URL(path, import.meta.url)).find((url) => existsSync(url));
  if (!found || !existsSync(found))
    throw new LissomError('kernel-not-found', 'kernel.wasm is missing. Build it with: npm run wasm', 'crash');
  return WebAssembly.compile(new Uint8Array(await readFile(found)));
}
