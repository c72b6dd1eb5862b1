const TAB = 9;
const LF = 10;
const CR = 13;
const SPACE = 32;
const PLUS = 43;
const MINUS = 45;
const DOT = 46;
const SLASH = 47;
const BACKSLASH = 92;

/** Powers of ten that a double holds exactly. */
const TEN = Array.from({ length: 23 }, (_, i) => Number(`1e${i}`));
/** While a whole number is at most this, one more decimal digit keeps it exact. */
const LAST_EXACT = Math.floor((2 ** 53 - 9) / 10);

/** What C libraries print for numbers that are not: nan, -nan(ind), 1.#QNAN, 1.#INF … */
const INFINITE = /^([+-]?)(?:inf|infinity|1\.#inf0*)$/i;

/**
 * Walks over the words of a text file without making strings. Lines end in LF, CR LF or CR; a backslash at the
 * end of a line continues it where `continued` is set (OBJ).
 */
export class TextScanner {
  /** 1-based. */
  line = 1;

  constructor(
    readonly bytes: Uint8Array,
    public at = 0,
    readonly continued = false,
  ) {}

  get atEnd(): boolean {
    return this.at >= this.bytes.length;
  }

  /** Skips blanks; true where the line, or the file, has no further word. */
  atLineEnd(): boolean {
    const { bytes } = this;
    for (;;) {
      const c = bytes[this.at];
      if (c === SPACE || c === TAB) this.at++;
      else if (c === BACKSLASH && this.continued && this.#endsLine(bytes[this.at + 1])) {
        this.at++;
        this.#passLineEnd();
      } else return c === undefined || c === LF || c === CR;
    }
  }

  nextLine(): void {
    const { bytes } = this;
    while (!this.atEnd) {
      const c = bytes[this.at];
      if (c === LF || c === CR) break;
      if (c === BACKSLASH && this.continued && this.#endsLine(bytes[this.at + 1])) {
        this.at++;
        this.#passLineEnd();
      } else this.at++;
    }
    this.#passLineEnd();
  }

  /** Skips blanks and line ends; false at the end of the file. */
  toNextWord(): boolean {
    while (this.atLineEnd()) {
      if (this.atEnd) return false;
      this.#passLineEnd();
    }
    return true;
  }

  /** The rest of the line without surrounding blanks. Does not pass the line's end. */
  restOfLine(): string {
    this.atLineEnd();
    const start = this.at;
    while (!this.atEnd && !this.#endsLine(this.bytes[this.at])) this.at++;
    return decode(this.bytes, start, this.at).trimEnd();
  }

  word(): string {
    this.atLineEnd();
    const start = this.at;
    this.#passWord();
    return decode(this.bytes, start, this.at);
  }

  /** The value of the next word, correctly rounded; NaN where it is no number. Call only where a word stands. */
  number(): number {
    this.atLineEnd();
    const { bytes } = this;
    const start = this.at;
    let at = start;
    let c = bytes[at];
    const negative = c === MINUS;
    if (negative || c === PLUS) c = bytes[++at];
    let digits = 0;
    let whole = 0;
    let scale = 0;
    let exact = true;
    for (; isDigit(c); c = bytes[++at], digits++) {
      if (whole > LAST_EXACT) exact = false;
      whole = whole * 10 + (c as number) - 48;
    }
    if (c === DOT)
      for (c = bytes[++at]; isDigit(c); c = bytes[++at], digits++, scale--) {
        if (whole > LAST_EXACT) exact = false;
        whole = whole * 10 + (c as number) - 48;
      }
    if (digits > 0 && (c === 101 || c === 69)) {
      c = bytes[++at];
      const down = c === MINUS;
      if (down || c === PLUS) c = bytes[++at];
      let exponent = 0;
      let length = 0;
      for (; isDigit(c); c = bytes[++at], length++) exponent = exponent * 10 + (c as number) - 48;
      if (length > 6) exact = false;
      scale += down ? -exponent : exponent;
      if (length === 0) digits = 0;
    }
    if (digits === 0 || !this.#endsWord(at)) {
      this.#passWord();
      return oddNumber(decode(bytes, start, this.at));
    }
    this.at = at;
    // A whole number below 2^53 and a power of ten up to 22 are exact, so one operation rounds once.
    if (exact && scale >= -22 && scale <= 22) {
      const value = scale < 0 ? whole / TEN[-scale]! : whole * TEN[scale]!;
      return negative ? -value : value;
    }
    const plain = at - start <= 32;
    return Number(plain ? String.fromCharCode(...bytes.subarray(start, at)) : decode(bytes, start, at));
  }

  /** A whole number with an optional sign, up to a blank, a slash or the line's end; NaN otherwise. */
  integer(): number {
    const { bytes } = this;
    let at = this.at;
    let c = bytes[at];
    const negative = c === MINUS;
    if (negative || c === PLUS) c = bytes[++at];
    const first = at;
    let value = 0;
    for (; isDigit(c); c = bytes[++at]) value = value * 10 + (c as number) - 48;
    const ends = at > first && (c === SLASH || this.#endsWord(at));
    if (!ends) while (!this.#endsWord(at) && bytes[at] !== SLASH) at++;
    this.at = at;
    return ends ? (negative ? -value : value) : NaN;
  }

  /** Steps over a slash, if one stands here. */
  slash(): boolean {
    if (this.bytes[this.at] !== SLASH) return false;
    this.at++;
    return true;
  }

  #passWord(): void {
    while (!this.#endsWord(this.at)) this.at++;
  }

  #endsWord(at: number): boolean {
    const c = this.bytes[at];
    return (
      c === undefined ||
      c === SPACE ||
      c === TAB ||
      c === LF ||
      c === CR ||
      (c === BACKSLASH && this.continued && this.#endsLine(this.bytes[at + 1]))
    );
  }

  #endsLine(c: number | undefined): boolean {
    return c === undefined || c === LF || c === CR;
  }

  #passLineEnd(): void {
    if (this.atEnd) return;
    if (this.bytes[this.at] === CR && this.bytes[this.at + 1] === LF) this.at++;
    this.at++;
    this.line++;
  }
}

/** UTF-8 from `start` to `end`; what is not UTF-8 becomes the replacement character. */
export function decode(bytes: Uint8Array, start = 0, end = bytes.length): string {
  if (end - start > 24) return new TextDecoder().decode(bytes.subarray(start, end));
  let text = '';
  for (let i = start; i < end; i++) {
    if (bytes[i]! > 127) return new TextDecoder().decode(bytes.subarray(start, end));
    text += String.fromCharCode(bytes[i]!);
  }
  return text;
}

const isDigit = (c: number | undefined): boolean => c !== undefined && c >= 48 && c <= 57;

/** A word that is no plain decimal: infinity in one of its spellings, or NaN. */
function oddNumber(word: string): number {
  const infinite = INFINITE.exec(word);
  if (!infinite) return NaN;
  return infinite[1] === '-' ? -Infinity : Infinity;
}
