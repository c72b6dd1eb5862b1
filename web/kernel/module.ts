import type { KernelModule } from '../../wasm/bindings/kernel';
import createKernel from '../../wasm/dist/kernel.mjs';

/** A fresh kernel with a memory of its own. The caller compiles: how depends on where the bytes are. */
export function instantiate(compiled: WebAssembly.Module): Promise<KernelModule> {
  return new Promise((resolve, reject) => {
    createKernel({
      instantiateWasm(imports, receive) {
        try {
          const instance = new WebAssembly.Instance(compiled, imports);
          receive(instance, compiled);
          return instance.exports;
        } catch (error) {
          reject(error); // Emscripten would only log it
          throw error;
        }
      },
    }).then(resolve, reject);
  });
}
