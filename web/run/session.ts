import { Hasher } from '../core/hash';
import { Lru } from '../core/lru';
import type { Model } from '../core/model';
import type {
  Args,
  CallOptions,
  DeformId,
  HairId,
  KernelPort,
  MergeId,
  Method,
  ModelId,
  OpenedHair,
  PreparedDeform,
  PreparedMerge,
  Result,
  StyledHair,
} from '../kernel/contract';
import type { ModelResult } from './types';

/** Models open in the kernel at a time. */
const OPEN_MODELS = 8;
/** Factored systems kept: the one being dragged, and the ones to switch back to. */
const SESSIONS = 3;
/** Heads prepared for hair that are kept. */
const HEADS = 2;

/** A head prepared for hair, and the style that the kernel holds for it now. */
interface HeldHair {
  readonly opened: OpenedHair;
  style?: { readonly key: string; readonly styled: StyledHair };
}

/**
 * What the kernel holds for us: opened models and factored systems, by content. All ids die with the worker
 * (another `epoch`); then everything is opened and prepared anew as it is asked for.
 */
export class KernelSession {
  #epoch: number;
  readonly #models = new Lru<ModelResult>(OPEN_MODELS, ({ opened }) => this.#release(opened.model));
  readonly #prepared = new Lru<PreparedDeform>(SESSIONS, ({ deform }) => this.#release(deform));
  readonly #merges = new Lru<PreparedMerge>(SESSIONS, ({ merge }) => this.#release(merge));
  readonly #hair = new Lru<HeldHair>(HEADS, ({ opened }) => this.#release(opened.hair));
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

  async prepareMerge(key: string, args: Args<'prepareMerge'>, given: CallOptions): Promise<PreparedMerge> {
    this.#sync();
    const known = this.#merges.get(key);
    if (known) return known;
    const prepared = await this.call('prepareMerge', args, given);
    this.#merges.set(key, prepared);
    return prepared;
  }

  /** @param key  of head, scalp and resolution */
  async openHair(key: string, args: Args<'openHair'>, given: CallOptions): Promise<OpenedHair> {
    this.#sync();
    const known = this.#hair.get(key);
    if (known) return known.opened;
    const opened = await this.call('openHair', args, given);
    this.#hair.set(key, { opened });
    return opened;
  }

  /** Gives a head its style, unless it has it. @param headKey  as in `openHair`, which comes before */
  async styleHair(
    headKey: string,
    styleKey: string,
    args: Args<'styleHair'>,
    given: CallOptions,
  ): Promise<StyledHair> {
    const held = this.#hair.get(headKey);
    if (held?.style?.key === styleKey) return held.style.styled;
    if (held) delete held.style; // whatever happens now, the kernel's style is no longer that one
    const styled = await this.call('styleHair', args, given);
    if (held) held.style = { key: styleKey, styled };
    return styled;
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
    this.#merges.clear();
    this.#hair.clear();
    this.#epoch = this.kernel.epoch;
  }

  #release(id: ModelId | DeformId | MergeId | HairId): void {
    // A worker that dies meanwhile has freed it already.
    if (!this.isStale) this.kernel.call('release', { id }).catch(() => {});
  }
}

const options = (signal: AbortSignal | undefined): CallOptions => (signal ? { signal } : {});
