import { Hasher } from '../core/hash';
import { Lru } from '../core/lru';
import type { Model } from '../core/model';
import type {
  Args,
  CallOptions,
  DeformId,
  KernelPort,
  Method,
  ModelId,
  PreparedDeform,
  Result,
} from '../kernel/contract';
import type { ModelResult } from './types';

/** Models open in the kernel at a time. */
const OPEN_MODELS = 8;
/** Factored systems kept: the one being dragged, and the ones to switch back to. */
const SESSIONS = 3;

/**
 * What the kernel holds for us: opened models and factored systems, by content. All ids die with the worker
 * (another `epoch`); then everything is opened and prepared anew as it is asked for.
 */
export class KernelSession {
  #epoch: number;
  readonly #models = new Lru<ModelResult>(OPEN_MODELS, ({ opened }) => this.#release(opened.model));
  readonly #prepared = new Lru<PreparedDeform>(SESSIONS, ({ deform }) => this.#release(deform));
  readonly #keys = new WeakMap<Model, string>();

  constructor(private readonly kernel: KernelPort) {
    this.#epoch = kernel.epoch;
  }

  /** @param key  hash of the content where it is known already: that of the result it is */
  async open(model: Model, signal?: AbortSignal, key = this.keyOf(model)): Promise<ModelResult> {
    this.#sync();
    const known = this.#models.get(key);
    if (known) return known.model === model ? known : { ...known, model };
    const { positions, faceOffsets, faceVertices } = model;
    const opened = await this.call('openModel', { positions, faceOffsets, faceVertices }, options(signal));
    const result = { model, opened, key };
    this.#models.set(key, result);
    return result;
  }

  async prepare(key: string, args: Args<'prepareDeform'>, given: CallOptions): Promise<PreparedDeform> {
    this.#sync();
    const known = this.#prepared.get(key);
    if (known) return known;
    const prepared = await this.call('prepareDeform', args, given);
    this.#prepared.set(key, prepared);
    return prepared;
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

  #sync(): void {
    if (!this.isStale) return;
    this.#models.clear();
    this.#prepared.clear();
    this.#epoch = this.kernel.epoch;
  }

  #release(id: ModelId | DeformId): void {
    // A worker that dies meanwhile has freed it already.
    if (!this.isStale) this.kernel.call('release', { id }).catch(() => {});
  }
}

const options = (signal: AbortSignal | undefined): CallOptions => (signal ? { signal } : {});
