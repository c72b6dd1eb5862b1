// What a call costs. Memory is held to its bound; time is printed, for a bound on it would hold on one machine and fail on
// another.

import { expect } from 'vitest';
import { LissomError } from '../../web/core/errors';

export interface Spent<T> {
  readonly value: T;
  /** Elements of the typed arrays made by their length while the call ran. */
  readonly made: number;
}

/** What refusing anything may take beyond its input, in MB. */
const MOST_MEGABYTES = 256;

/**
 * Notes what the process holds. @returns says and checks what it came to since: the highest that it stood at, or stood at
 * ever before, over where it stood then. What is set aside and given back within counts.
 */
export function meter(what: string): (more?: string) => void {
  const before = process.memoryUsage.rss();
  const started = performance.now();
  return (more = '') => {
    const seconds = (performance.now() - started) / 1000;
    const peak = 1024 * process.resourceUsage().maxRSS;
    const megabytes = Math.max(0, peak - before) / 1e6;
    console.log(`${what.padEnd(64)} ${seconds.toFixed(3)} s, at most ${megabytes.toFixed(0)} MB${more}`);
    expect(megabytes, `MB for ${what}`).toBeLessThan(MOST_MEGABYTES);
  };
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
  const done = meter(what);
  try {
    return { value: call(), made };
  } finally {
    for (const [name, array] of kept) whole[name] = array;
    done(`, ${made.toLocaleString('en-US')} values set aside`);
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
