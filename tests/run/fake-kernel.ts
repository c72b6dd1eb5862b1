// A kernel of few lines: handles move their own vertices, the rest stays; a pose moves a handle of another model as it
// moved the first vertex of its own. It keeps a record of what was asked.

import { LissomError } from '../../web/core/errors';
import type { Args, CallOptions, KernelPort, Method, Result } from '../../web/kernel/contract';

interface Opened {
  readonly positions: Float64Array;
}
interface Prepared {
  readonly model: number;
  readonly handles: Args<'prepareDeform'>['handles'];
}

interface Paired extends Omit<Args<'prepareTransfer'>, 'source' | 'target'> {
  readonly source: Opened;
  readonly target: Opened;
}

const IDS_PER_EPOCH = 1000;

export class FakeKernel implements KernelPort {
  epoch = 0;
  /** Names of the calls so far, in order. */
  calls: string[] = [];
  /** Runs before each call is answered; may throw, restart or abort. */
  before: (method: Method, options: CallOptions) => void | Promise<void> = () => {};
  readonly #models = new Map<number, Opened>();
  readonly #sessions = new Map<number, Prepared>();
  readonly #paired = new Map<number, Paired>();
  #nextId = 1;

  /** As when the worker is replaced: everything it held is gone. */
  restart(): void {
    this.epoch++;
    this.#models.clear();
    this.#sessions.clear();
    this.#paired.clear();
    this.#nextId = this.epoch * IDS_PER_EPOCH + 1;
  }

  get held(): { models: number; sessions: number } {
    return { models: this.#models.size, sessions: this.#sessions.size + this.#paired.size };
  }

  /** How often a method was called since the last look at it. */
  take(): Record<string, number> {
    const counts: Record<string, number> = {};
    for (const method of this.calls) if (method !== 'release') counts[method] = (counts[method] ?? 0) + 1;
    this.calls = [];
    return counts;
  }

  async call<M extends Method>(method: M, args: Args<M>, options: CallOptions = {}): Promise<Result<M>> {
    this.calls.push(method);
    await this.before(method, options);
    if (options.signal?.aborted) throw new LissomError('cancelled', 'Cancelled.', 'cancelled');
    return this.#answer(method, args as never) as Result<M>;
  }

  #answer(method: Method, args: Record<string, unknown>): unknown {
    switch (method) {
      case 'openModel':
        return this.#open(args as never);
      case 'prepareDeform':
        return this.#prepare(args as never);
      case 'deform':
        return this.#deform(args as never);
      case 'prepareTransfer':
        return this.#pair(args as never);
      case 'transfer':
        return this.#transfer(args as never);
      case 'measure':
        return {
          volumeRatio: 1,
          edgeRms: 0,
          worstStretch: 0,
          flippedTriangles: 0,
          stretch: new Float32Array(),
        };
      case 'release':
        this.#models.delete(args.id as number);
        this.#sessions.delete(args.id as number);
        this.#paired.delete(args.id as number);
    }
    return undefined;
  }

  #open({ positions, faceOffsets }: Args<'openModel'>): unknown {
    const model = this.#nextId++;
    this.#models.set(model, { positions: positions.slice() });
    const findings =
      faceOffsets.length < 2 ? [{ code: 'no-faces', count: 1, examples: [], repaired: false }] : [];
    return { id: model, findings, triangles: new Uint32Array(), components: 1 };
  }

  #prepare({ model, handles }: Args<'prepareDeform'>): unknown {
    found(this.#models, model);
    const deform = this.#nextId++;
    this.#sessions.set(deform, { model, handles });
    return {
      id: deform,
      free: 5,
      degenerate: 2,
      warnings: [],
      seconds: { assemble: 0.1, factor: 0.2 },
      peakBytes: 99,
    };
  }

  #deform({ deform, targets }: Args<'deform'>): unknown {
    const { model, handles } = found(this.#sessions, deform);
    const positions = found(this.#models, model).positions.slice();
    for (const [at, { vertices }] of handles.entries())
      for (const vertex of vertices)
        for (let axis = 0; axis < 3; axis++) positions[3 * vertex + axis]! += targets[16 * at + 12 + axis]!;
    return { positions, iterations: 1, warnings: [], seconds: { solve: 0.3, rotate: 0.4, reconstruct: 0.5 } };
  }

  #pair({ source, target, ...handles }: Args<'prepareTransfer'>): unknown {
    const models = { source: found(this.#models, source), target: found(this.#models, target) };
    const id = this.#nextId++;
    this.#paired.set(id, { ...models, ...handles });
    return { id, unknowns: 40, warnings: [], seconds: { fields: 0.1, reduce: 0.2 }, peakBytes: 99 };
  }

  #transfer({ transfer, pose, strength }: Args<'transfer'>): unknown {
    const { source, target, sourceHandles, targetHandles } = found(this.#paired, transfer);
    const positions = target.positions.slice();
    for (const [at, vertices] of targetHandles.entries())
      for (const vertex of vertices)
        for (let axis = 0; axis < 3; axis++) {
          const k = 3 * sourceHandles[at]![0]! + axis;
          positions[3 * vertex + axis]! += strength * (pose[k]! - source.positions[k]!);
        }
    return { positions, iterations: 1, warnings: [], seconds: { perIteration: 0.3, solve: 0.4 } };
  }
}

function found<T>(held: ReadonlyMap<number, T>, id: number): T {
  const object = held.get(id);
  if (!object) throw new LissomError('worker-restarted', 'The solver was restarted.', 'crash');
  return object;
}
