/// <reference types="vite/client" />

// Built by scripts/wasm.mjs, so not there for the compiler to look at.
declare module '*/dist/kernel.mjs' {
  type Kernel = import('../wasm/bindings/kernel').KernelModule;
  type Settings = import('../wasm/bindings/kernel').KernelSettings;
  export default function createKernel(settings: Settings): Promise<Kernel>;
}
