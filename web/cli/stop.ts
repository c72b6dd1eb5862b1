// What ends a run before its end: Ctrl-C, and the time it was given.

import { LissomError } from '../core/errors';

export interface Stop {
  readonly signal: AbortSignal;
  /** @throws LissomError `interrupted`, `timed-out`, if it is over */
  check(): void;
  /** What went wrong, told as what ended the run where it was that. */
  reason(error: unknown): unknown;
  release(): void;
}

/**
 * @param seconds      the run may take; as long as it needs when left out
 * @param onInterrupt  calls back on Ctrl-C; returns what forgets it
 */
export function stopAfter(seconds: number | undefined, onInterrupt: (stop: () => void) => () => void): Stop {
  const controller = new AbortController();
  const { signal } = controller;
  const end = (code: string, message: string) => {
    if (!signal.aborted) controller.abort(new LissomError(code, message, 'cancelled'));
  };
  const forget = onInterrupt(() => end('interrupted', 'The run was interrupted; nothing was written.'));
  const timer =
    seconds !== undefined &&
    setTimeout(
      () => end('timed-out', `The run took longer than ${seconds} s and was ended; nothing was written.`),
      1000 * seconds,
    );
  return {
    signal,
    check: () => signal.throwIfAborted(),
    reason: (error) => (signal.aborted ? signal.reason : error),
    release() {
      forget();
      if (timer) clearTimeout(timer);
    },
  };
}
