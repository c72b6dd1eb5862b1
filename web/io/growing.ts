// Typed arrays that grow, for readers that learn the length at the end. Each growth is asked of the file's budget first.

import type { Budget } from './budget';

const FIRST = 1024;

export class GrowingFloat64 {
  #values = new Float64Array(FIRST);
  length = 0;

  constructor(private readonly budget?: Budget) {}

  push(value: number): void {
    if (this.length === this.#values.length) {
      this.budget?.take(this.#values.byteLength);
      const larger = new Float64Array(2 * this.length);
      larger.set(this.#values);
      this.#values = larger;
    }
    this.#values[this.length++] = value;
  }
  finish(): Float64Array {
    return this.#values.slice(0, this.length);
  }
}

export class GrowingUint32 {
  #values = new Uint32Array(FIRST);
  length = 0;

  constructor(private readonly budget?: Budget) {}

  push(value: number): void {
    if (this.length === this.#values.length) {
      this.budget?.take(this.#values.byteLength);
      const larger = new Uint32Array(2 * this.length);
      larger.set(this.#values);
      this.#values = larger;
    }
    this.#values[this.length++] = value;
  }
  finish(): Uint32Array {
    return this.#values.slice(0, this.length);
  }
}
