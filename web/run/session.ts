import { Hasher } from '../core/hash';
import { Lru } from '../core/lru';
import type { Model } from '../core/model';
import type { Args, CallOptions, KernelId, KernelPort, Method, Result } from '../kernel/contract';
import type { OpenedModel } from '../kernel/contract/model';
import type { ModelResult } from './types';

/** How many answers of a method are kept, the ones used last, with what the kernel holds for each. */
export type Capacities = { readonly [M in Method]?: number };

export interface HoldOptions extends CallOptions {
  /** The held thing whose state the answer tells: it is in one state at a time, and loses it with itself. */
  readonly of?: KernelId;
}

const MODELS: Capacities = { openModel: 8 };

/**
 * What the kernel holds for us: opened models, and whatever steps prepare, by content. All ids die with the worker
 * (another `epoch`); then everything is opened and prepared anew as it is asked for.
 */
export class KernelSession {
  #epoch: number;
  readonly #capacities: Capacities;
  /** Answers by method, for each held thing those that tell its state; by themselves under `undefined`. */
  readonly #held = new Map<KernelId | undefined, Map<Method, Lru<unknown>>>();
  readonly #results = new WeakMap<OpenedModel, ModelResult>();
  readonly #keys = new WeakMap<Model, string>();

  /** @param capacities  of what steps prepare; one where it does not say */
  constructor(
    private readonly kernel: KernelPort,
    capacities: Capacities,
  ) {
    this.#epoch = kernel.epoch;
    this.#capacities = { ...MODELS, ...capacities };
  }

  /** @param key  hash of the content where it is known already: that of the result it is */
  async open(model: Model, signal?: AbortSignal, key = this.keyOf(model)): Promise<ModelResult> {
    const { positions, faceOffsets, faceVertices } = model;
    const args = { positions, faceOffsets, faceVertices };
    const opened = await this.hold('openModel', key, args, signal ? { signal } : {});
    const known = this.#results.get(opened) ?? { model, opened, key };
    this.#results.set(opened, known);
    return known.model === model ? known : { ...known, model };
  }

  /**
   * The answer of a method that makes the kernel hold something, or changes the state of what it holds. What is still
   * held, or still in that state, is not asked for again.
   *
   * @param key   of all that the answer depends on
   * @param args  or how they are made, where that takes time: a drag comes by here every frame
   */
  async hold<M extends Method>(
    method: M,
    key: string,
    args: Args<M> | (() => Args<M>),
    { of, ...options }: HoldOptions = {},
  ): Promise<Result<M>> {
    this.#sync();
    const kept = this.#keptFor(method, of);
    const known = kept.get(key) as Result<M> | undefined;
    if (known) return known;
    // Whatever comes of it, the state before is gone.
    if (of !== undefined) kept.clear();
    const answer = await this.call(method, typeof args === 'function' ? args() : args, options);
    kept.set(key, answer);
    return answer;
  }

  call<M extends Method>(method: M, args: Args<M>, given?: CallOptions): Promise<Result<M>> {
    return this.kernel.call(method, args, given);
  }

  /** Whether the worker was replaced since the ids in hand were given out. */
  get isStale(): boolean {
    return this.kernel.epoch !== this.#epoch;
  }

  /** Hash of what the kernel and the steps see of a model. */
  keyOf(model: Model): string {
    let key = this.#keys.get(model);
    if (key === undefined) {
      key = new Hasher().bytes(model.positions).bytes(model.faceOffsets).bytes(model.faceVertices).digest();
      this.#keys.set(model, key);
    }
    return key;
  }

  #keptFor(method: Method, of: KernelId | undefined): Lru<unknown> {
    const byMethod = this.#held.get(of) ?? new Map<Method, Lru<unknown>>();
    this.#held.set(of, byMethod);
    const capacity = of === undefined ? (this.#capacities[method] ?? 1) : 1;
    const kept = byMethod.get(method) ?? new Lru(capacity, (answer) => this.#release(answer));
    byMethod.set(method, kept);
    return kept;
  }

  #sync(): void {
    if (!this.isStale) return;
    this.#held.clear();
    this.#epoch = this.kernel.epoch;
  }

  #release(answer: unknown): void {
    const { id } = (answer ?? {}) as { readonly id?: KernelId };
    if (id === undefined) return;
    this.#held.delete(id);
    // A worker that dies meanwhile has freed it already.
    if (!this.isStale) this.kernel.call('release', { id }).catch(() => {});
  }
}
