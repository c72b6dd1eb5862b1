import { isMainThread } from 'node:worker_threads';
import { serveInThread, startThread } from '../kernel/thread';
import { cli } from './cli';

// The same file twice: as the command, and in the thread that the command gives its kernel.
if (isMainThread)
  process.exitCode = await cli(process.argv.slice(2), process, {
    kernel: async () => startThread(new URL(import.meta.url)),
    onInterrupt,
  });
else serveInThread();

/** Once: what does not end on the first Ctrl-C ends the hard way on the second. */
function onInterrupt(stop: () => void): () => void {
  const signals = ['SIGINT', 'SIGTERM'] as const;
  const listen = () => {
    release();
    stop();
  };
  const release = () => {
    for (const signal of signals) process.off(signal, listen);
  };
  for (const signal of signals) process.on(signal, listen);
  return release;
}
