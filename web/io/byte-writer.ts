/**
 * A file under construction: bytes appended to a buffer that doubles when it is full, so that a model of any
 * size never passes through one giant string. Numbers are little endian.
 */
export class ByteWriter {
  #bytes: Uint8Array<ArrayBuffer>;
  #view: DataView;
  #length = 0;

  /** @param expected  bytes to set aside at first; a guess is enough */
  constructor(expected = 4096) {
    this.#bytes = new Uint8Array(Math.max(64, Math.ceil(expected)));
    this.#view = new DataView(this.#bytes.buffer);
  }

  get length(): number {
    return this.#length;
  }

  byte(value: number): void {
    const at = this.#room(1);
    this.#bytes[at] = value;
  }
  u16(value: number): void {
    const at = this.#room(2);
    this.#view.setUint16(at, value, true);
  }
  u32(value: number): void {
    const at = this.#room(4);
    this.#view.setUint32(at, value, true);
  }
  f32(value: number): void {
    const at = this.#room(4);
    this.#view.setFloat32(at, value, true);
  }
  f64(value: number): void {
    const at = this.#room(8);
    this.#view.setFloat64(at, value, true);
  }

  raw(bytes: Uint8Array): void {
    const at = this.#room(bytes.length);
    this.#bytes.set(bytes, at);
  }

  /** UTF-8. */
  text(text: string): void {
    let at = this.#room(text.length);
    for (let i = 0; i < text.length; i++) {
      const code = text.charCodeAt(i);
      if (code > 127) {
        this.#length = at;
        this.raw(new TextEncoder().encode(text.slice(i)));
        return;
      }
      this.#bytes[at++] = code;
    }
  }

  /** The shortest decimal that reads back as the same double. `nan` and `inf` are spelt as C prints them. */
  decimal(value: number): void {
    if (Number.isFinite(value)) this.text(Object.is(value, -0) ? '-0' : String(value));
    else this.text(Number.isNaN(value) ? 'nan' : value > 0 ? 'inf' : '-inf');
  }

  align(multiple: number, filler = 0): void {
    while (this.#length % multiple !== 0) this.byte(filler);
  }

  /** The bytes written so far, in an array of exactly that length. */
  finish(): Uint8Array<ArrayBuffer> {
    return this.#bytes.slice(0, this.#length);
  }

  /** Where `count` new bytes go. Call it before touching the buffer, which it may replace. */
  #room(count: number): number {
    const at = this.#length;
    this.#length += count;
    if (this.#length > this.#bytes.length) {
      const larger = new Uint8Array(Math.max(this.#length, 2 * this.#bytes.length));
      larger.set(this.#bytes.subarray(0, at));
      this.#bytes = larger;
      this.#view = new DataView(larger.buffer);
    }
    return at;
  }
}
