import { type Fault, LissomError } from '../core/errors';
import type { Failure } from './messages';

const OUT_OF_MEMORY =
  'There is not enough memory for this. Nothing is lost; try a smaller region, or a model with fewer vertices.';

/** What an id of an earlier epoch, or work lost with its worker, ends in: do it again with new ids. */
export const workerRestarted = (): LissomError =>
  new LissomError('worker-restarted', 'The solver was restarted; this has to be computed again.', 'crash');

export const notLoaded = (reason: string): LissomError =>
  new LissomError(
    'kernel-not-loaded',
    `The solver could not be loaded (${reason}). Check the connection and try again.`,
    'crash',
  );

/** Whatever a handler threw, as a message. Only the kernel's own refusals leave the kernel in a sound state. */
export function failureOf(thrown: unknown): Failure {
  const { code, fault, message } = described(thrown);
  if (fault === 'memory' || isOutOfMemory(thrown))
    return { code: 'out-of-memory', message: OUT_OF_MEMORY, fault: 'memory', fatal: true };
  if (code && fault) return { code, message, fault, fatal: fault === 'crash' && code !== 'worker-restarted' };
  return {
    code: 'kernel-crash',
    message: `The solver failed unexpectedly (${message}). Nothing is lost; it has been restarted.`,
    fault: 'crash',
    fatal: true,
  };
}

export const toError = ({ code, message, fault }: Failure): LissomError =>
  new LissomError(code, message, fault);

function described(thrown: unknown): { code?: string; fault?: Fault; message: string } {
  return thrown instanceof Error ? thrown : { message: String(thrown) };
}

/** Engines and Emscripten word it differently: "Aborted(OOM)", "Array buffer allocation failed" … */
function isOutOfMemory(thrown: unknown): boolean {
  return (
    (thrown instanceof RangeError || thrown instanceof WebAssembly.RuntimeError) &&
    /\boom\b|out of memory|memory\.grow|enlarge memory|allocation failed|invalid (typed )?array (buffer )?length/i.test(
      thrown.message,
    )
  );
}
