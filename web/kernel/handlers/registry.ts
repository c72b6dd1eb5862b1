import type { WasmObject } from '../../../wasm/bindings/model';
import type { KernelId } from '../contract';
import { workerRestarted } from '../failures';

/** More ids than a worker can ever give out: ids of different epochs never meet. */
const IDS_PER_EPOCH = 2 ** 32;

/** C++ objects behind integer ids. The only place that frees them. */
export class Registry {
  #nextId: number;
  readonly #objects = new Map<KernelId, WasmObject>();

  constructor(epoch: number) {
    this.#nextId = epoch * IDS_PER_EPOCH + 1;
  }

  add(object: WasmObject): KernelId {
    const id = this.#nextId++ as KernelId;
    this.#objects.set(id, object);
    return id;
  }

  /** @throws LissomError `worker-restarted` if the id is of an earlier epoch, or released */
  get<T extends WasmObject>(id: KernelId, kind: new (...args: never[]) => T): T {
    const object = this.#objects.get(id);
    if (!(object instanceof kind)) throw workerRestarted();
    return object;
  }

  /** Unknown ids are ignored. */
  release(id: KernelId): void {
    this.#objects.get(id)?.delete();
    this.#objects.delete(id);
  }
}
