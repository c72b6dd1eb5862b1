// Bytes out and in. Every count read is checked against what is left, so no link can make the reader
// allocate more than it sent.

import { damaged } from './errors';

export class ByteWriter {
  #bytes: Uint8Array = new Uint8Array(256);
  #length = 0;

  byte(value: number): void {
    this.#room(1)[this.#length++] = value;
  }

  /** LEB128, least significant seven bits first; `value` in [0, 2^53). */
  varint(value: number): void {
    let left = value;
    for (; left >= 128; left = Math.floor(left / 128)) this.byte((left % 128) | 128);
    this.byte(left);
  }

  /** Small magnitudes of either sign in few bytes: 0, −1, 1, −2 … are 0, 1, 2, 3 … */
  zigzag(value: number): void {
    this.varint(value < 0 ? -2 * value - 1 : 2 * value);
  }

  float32(value: number): void {
    const bytes = this.#room(4);
    new DataView(bytes.buffer).setFloat32(this.#length, value, true);
    this.#length += 4;
  }

  float64(value: number): void {
    const bytes = this.#room(8);
    new DataView(bytes.buffer).setFloat64(this.#length, value, true);
    this.#length += 8;
  }

  raw(bytes: Uint8Array): void {
    this.#room(bytes.length).set(bytes, this.#length);
    this.#length += bytes.length;
  }

  done(): Uint8Array {
    return this.#bytes.slice(0, this.#length);
  }

  #room(more: number): Uint8Array {
    if (this.#length + more > this.#bytes.length) {
      const grown = new Uint8Array(Math.max(2 * this.#bytes.length, this.#length + more));
      grown.set(this.#bytes);
      this.#bytes = grown;
    }
    return this.#bytes;
  }
}

/** @throws LissomError `link-damaged` when the bytes end too early or a number is too large */
export class ByteReader {
  #at = 0;
  readonly #view: DataView;

  constructor(private readonly bytes: Uint8Array) {
    this.#view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  }

  get left(): number {
    return this.bytes.length - this.#at;
  }

  byte(): number {
    return this.#view.getUint8(this.#take(1));
  }

  varint(): number {
    let value = 0;
    for (let scale = 1; scale < 2 ** 53; scale *= 128) {
      const byte = this.byte();
      value += (byte & 127) * scale;
      if (byte < 128) {
        if (value > Number.MAX_SAFE_INTEGER) break;
        return value;
      }
    }
    throw damaged();
  }

  /** A varint that counts things of at least `size` bytes each that follow. */
  count(size = 1): number {
    const value = this.varint();
    if (value * size > this.left) throw damaged();
    return value;
  }

  zigzag(): number {
    const value = this.varint();
    return value % 2 === 1 ? -(value + 1) / 2 : value / 2;
  }

  float32(): number {
    return this.#view.getFloat32(this.#take(4), true);
  }

  float64(): number {
    return this.#view.getFloat64(this.#take(8), true);
  }

  rest(): Uint8Array {
    return this.bytes.subarray(this.#take(this.left));
  }

  #take(size: number): number {
    if (size > this.left) throw damaged();
    this.#at += size;
    return this.#at - size;
  }
}

/** Bytes that `varint` writes. */
export function varintLength(value: number): number {
  let length = 1;
  for (let left = value; left >= 128; left /= 128) length++;
  return length;
}

export const zigzagLength = (value: number): number => varintLength(value < 0 ? -2 * value - 1 : 2 * value);
