// Entry of the kernel's worker.

import wasmUrl from '../../wasm/dist/kernel.wasm?url';
import { notLoaded } from './failures';
import { createHandlers } from './handlers/all';
import type { Port } from './messages';
import { instantiate } from './module';
import { serve } from './serve';

async function compile(): Promise<WebAssembly.Module> {
  try {
    const response = await fetch(wasmUrl);
    if (!response.ok) throw new Error(`status ${response.status}`);
    const streams = response.headers.get('content-type')?.startsWith('application/wasm');
    return await (streams
      ? WebAssembly.compileStreaming(response)
      : WebAssembly.compile(await response.arrayBuffer()));
  } catch (error) {
    throw notLoaded(error instanceof Error ? error.message : String(error));
  }
}

serve(self as unknown as Port, async (epoch) => createHandlers(await instantiate(await compile()), epoch));
