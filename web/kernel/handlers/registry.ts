import type { WasmObject } from '../../../wasm/bindings/kernel';
import { workerRestarted } from '../failures';

/** More ids than a worker can ever give out: ids of different epochs never meet. */
const IDS_PER_EPOCH = 2 ** 32;

/** C++ objects behind integer ids. The only place that frees them. */
export class Registry {
  #nextId: number;
  readonly #objects = new Map<number, WasmObject>();

  constructor(epoch: number) {
    this.#nextId = epoch * IDS_PER_EPOCH + 1;
  }

  add<Id extends number>(object: WasmObject): Id {
    const id = this.#nextId++;
    this.#objects.set(id, object);
    return id as Id;
  }

  /** @throws LissomError `worker-restarted` if the id is of an earlier epoch, or released */
  get<T extends WasmObject>(id: number, kind: new (...args: never[]) => T): T {
    const object = this.#objects.get(id);
    if (!(object instanceof kind)) throw workerRestarted();
    return object;
  }

  /** Unknown ids are ignored. */
  release(id: number): void {
    this.#objects.get(id)?.delete();
    this.#objects.delete(id);
  }
}
