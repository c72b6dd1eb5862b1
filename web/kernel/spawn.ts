import { KernelClient, type WorkerLike } from './client';

/** The kernel in a worker of its own, as the page uses it. */
export const startKernel = (): KernelClient =>
  new KernelClient(
    () => new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' }) as unknown as WorkerLike,
  );
