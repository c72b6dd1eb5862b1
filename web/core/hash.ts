// Content hashes: equal content, equal key. 128 bits, fast, not cryptographic. Keys live as long as the
// program does and are never stored, so the byte order of the machine does not matter.

const LANES = [0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344] as const;
const STEP = 0x9e3779b1;
const MIX = 0x85ebca77;

/** Feeds on words of 32 bits, four lanes in turn; lengths are hashed too, so pieces cannot run together. */
export class Hasher {
  readonly #lanes = Uint32Array.from(LANES);
  #words = 0;

  word(value: number): this {
    const lane = this.#words++ & 3;
    const held = (this.#lanes[lane]! + Math.imul(value, MIX)) | 0;
    this.#lanes[lane] = Math.imul((held << 13) | (held >>> 19), STEP);
    return this;
  }

  number(value: number): this {
    FLOAT[0] = value;
    return this.word(FLOAT_WORDS[0]!).word(FLOAT_WORDS[1]!);
  }

  text(value: string): this {
    this.word(value.length);
    for (let i = 0; i < value.length; i++) this.word(value.charCodeAt(i));
    return this;
  }

  bytes(view: ArrayBufferView): this {
    const { buffer, byteOffset, byteLength } = view;
    // A view of words must start on a word; what does not is copied to a buffer of its own.
    if (byteOffset % 4 !== 0) return this.bytes(new Uint8Array(buffer, byteOffset, byteLength).slice());
    this.word(byteLength);
    for (const value of new Uint32Array(buffer, byteOffset, byteLength >> 2)) this.word(value);
    const whole = byteLength & ~3;
    for (const value of new Uint8Array(buffer, byteOffset + whole, byteLength - whole)) this.word(value);
    return this;
  }

  /** 32 hexadecimal digits. */
  digest(): string {
    const lanes = [...this.#lanes];
    // Two rounds let every lane reach every other before each is avalanched on its own.
    for (let round = 0; round < 2; round++)
      for (let i = 0; i < 4; i++)
        lanes[i] = avalanche(lanes[i]! ^ Math.imul(lanes[(i + 3) & 3]!, STEP) ^ this.#words);
    return lanes.map((lane) => (lane >>> 0).toString(16).padStart(8, '0')).join('');
  }
}

/** Hash of a JSON value. The order of an object's keys does not count; fields that are `undefined` are absent. */
export function hashValue(value: unknown): string {
  const hasher = new Hasher();
  feed(hasher, value);
  return hasher.digest();
}

const FLOAT = new Float64Array(1);
const FLOAT_WORDS = new Uint32Array(FLOAT.buffer);

function feed(hasher: Hasher, value: unknown): void {
  if (typeof value === 'number') hasher.word(1).number(value);
  else if (typeof value === 'string') hasher.word(2).text(value);
  else if (Array.isArray(value)) {
    hasher.word(3).word(value.length);
    for (const item of value) feed(hasher, item);
  } else if (value !== null && typeof value === 'object') {
    const entries = Object.entries(value).filter(([, held]) => held !== undefined);
    entries.sort(([a], [b]) => (a < b ? -1 : 1));
    hasher.word(4).word(entries.length);
    for (const [key, held] of entries) {
      hasher.text(key);
      feed(hasher, held);
    }
  } else hasher.word(value === true ? 5 : value === false ? 6 : 7);
}

function avalanche(value: number): number {
  let held = value;
  held = Math.imul(held ^ (held >>> 16), 0x7feb352d);
  held = Math.imul(held ^ (held >>> 15), 0x846ca68b);
  return held ^ (held >>> 16);
}
