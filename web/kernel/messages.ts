// What travels between page and worker; derived from the contract, so nothing is listed twice.

import type { Fault } from '../core/errors';
import type { Args, Look, Method, Result } from './contract';

export type Call = {
  [M in Method]: { readonly id: number; readonly method: M; readonly args: Args<M>; readonly looks?: true };
}[Method];

export type Request =
  /** Once, first: the worker's epoch, from which its ids follow. */
  { readonly start: number } | Call | { readonly cancel: number };

export interface Failure {
  readonly code: string;
  readonly message: string;
  readonly fault: Fault;
  /** The kernel cannot be trusted any more: replace the worker. */
  readonly fatal: boolean;
}

export type Reply =
  | { readonly ready: true }
  /** The kernel could not be loaded; nothing will ever be answered. */
  | { readonly unusable: Failure }
  /** The first one, always 0, says that the request has begun. */
  | { readonly id: number; readonly progress: number }
  | { readonly id: number; readonly look: Look }
  | { readonly id: number; readonly result: Result<Method> }
  | { readonly id: number; readonly error: Failure };

/** What a worker's global scope and a MessagePort have in common. */
export interface Port {
  postMessage(message: unknown, moved: Transferable[]): void;
  onmessage: ((event: MessageEvent) => void) | null;
}
