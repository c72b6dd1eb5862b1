// What a call sets aside, counted rather than timed: a bound on time would hold on one machine and fail on another.

import { LissomError } from '../../web/core/errors';

export interface Spent<T> {
  readonly value: T;
  /** Elements of the typed arrays made by their length while the call ran. */
  readonly made: number;
}

const ARRAYS = ['Float64Array', 'Float32Array', 'Uint32Array', 'Uint16Array', 'Uint8Array'] as const;

/** Runs a call and prints what it took. */
export function spent<T>(what: string, call: () => T): Spent<T> {
  let made = 0;
  const whole = globalThis as unknown as Record<string, typeof Float64Array>;
  const kept = ARRAYS.map((name) => [name, whole[name]!] as const);
  for (const [name, array] of kept)
    whole[name] = new Proxy(array, {
      construct(target, args: readonly unknown[], newTarget) {
        if (typeof args[0] === 'number') made += args[0];
        return Reflect.construct(target, args, newTarget === whole[name] ? target : newTarget);
      },
    });
  const started = performance.now();
  try {
    return { value: call(), made };
  } finally {
    for (const [name, array] of kept) whole[name] = array;
    const milliseconds = Math.round(performance.now() - started);
    console.log(`${what}: ${milliseconds} ms, ${made.toLocaleString('en-US')} values set aside`);
  }
}

/** The refusal of a call, and what it set aside before it. */
export function refusal(what: string, call: () => unknown): { code: string; message: string; made: number } {
  let caught: unknown;
  const { made } = spent(what, () => {
    try {
      call();
    } catch (error) {
      caught = error;
    }
  });
  if (!(caught instanceof LissomError)) throw caught ?? new Error(`${what} was accepted`);
  return { code: caught.code, message: caught.message, made };
}
