import type { ByteWriter } from '../byte-writer';

const POWERS = Array.from({ length: 10 }, (_, k) => Number(`1e${k}`));
const CHUNK = 1 << 16;
/** The longest number, with room to spare. */
const LONGEST = 48;
const ZERO = 48;

/** Words and decimals written by the million: a buffer of its own, handed on chunk by chunk. */
export class FixedText {
  readonly #out: ByteWriter;
  readonly #bytes = new Uint8Array(CHUNK);
  #at = 0;

  constructor(out: ByteWriter) {
    this.#out = out;
  }

  /** ASCII. */
  text(text: string): void {
    if (text.length > LONGEST) {
      this.flush();
      this.#out.text(text);
      return;
    }
    this.#makeRoom();
    for (let i = 0; i < text.length; i++) this.#bytes[this.#at++] = text.charCodeAt(i);
  }

  /** The value to `places` (0–9) decimals, without zeros at the end. */
  decimal(value: number, places: number): void {
    this.#makeRoom();
    const power = POWERS[places]!;
    const scaled = Math.round(Math.abs(value) * power);
    const whole = Math.floor(scaled / power);
    if (!(whole < 2 ** 31)) {
      this.text(String(value));
      return;
    }
    if (value < 0 && scaled > 0) this.#bytes[this.#at++] = 45;
    this.#digits(whole, 1);
    // Below 10⁹, so that the divisions are those of small integers.
    let rest = (scaled - whole * power) | 0;
    if (rest === 0) return;
    let width = places;
    for (let tenth = (rest / 10) | 0; tenth * 10 === rest; tenth = (rest / 10) | 0) {
      rest = tenth;
      width--;
    }
    this.#bytes[this.#at++] = 46;
    this.#digits(rest, width);
  }

  integer(value: number): void {
    this.#makeRoom();
    if (value < 2 ** 31) this.#digits(value, 1);
    else this.text(String(value));
  }

  flush(): void {
    this.#out.raw(this.#bytes.subarray(0, this.#at));
    this.#at = 0;
  }

  #makeRoom(): void {
    if (this.#at > CHUNK - LONGEST) this.flush();
  }

  /** @param value  a whole number in [0, 2³¹), written with `width` digits at least */
  #digits(value: number, width: number): void {
    let count = 1;
    for (let limit = 10; value >= limit; limit *= 10) count++;
    count = Math.max(count, width);
    let left = value | 0;
    for (let i = this.#at + count - 1; i >= this.#at; i--) {
      const tenth = (left / 10) | 0;
      this.#bytes[i] = ZERO + left - 10 * tenth;
      left = tenth;
    }
    this.#at += count;
  }
}

/** Decimals that give numbers up to `greatest` so many significant digits; eight are enough for single precision. */
export function placesFor(greatest: number, significant = 8): number {
  const whole = greatest > 0 ? Math.floor(Math.log10(greatest)) + 1 : 1;
  return Math.max(0, Math.min(9, significant - whole));
}
