import { LissomError } from '../core/errors';
import { PLY_BYTES, type PlyHeader, type PlyType } from './ply-header';
import { TextScanner } from './text-scanner';

/** The numbers of a PLY body, one after the other. */
export interface PlyValues {
  /** @throws LissomError `file-truncated` */
  next(type: PlyType): number;
  /** For messages: `line 7` or `byte 1024`. */
  readonly where: string;
}

export function plyValues(bytes: Uint8Array, header: PlyHeader, file: string): PlyValues {
  return header.encoding === 'ascii'
    ? new AsciiValues(bytes, header, file)
    : new BinaryValues(bytes, header, file);
}

class AsciiValues implements PlyValues {
  readonly #text: TextScanner;

  constructor(
    bytes: Uint8Array,
    header: PlyHeader,
    readonly file: string,
  ) {
    this.#text = new TextScanner(bytes, header.dataStart);
    this.#text.line = header.dataLine;
  }

  next(): number {
    if (!this.#text.toNextWord()) throw cutShort(this.file, this.where);
    return this.#text.number();
  }
  get where(): string {
    return `line ${this.#text.line}`;
  }
}

class BinaryValues implements PlyValues {
  readonly #view: DataView;
  readonly #little: boolean;
  #at: number;

  constructor(
    bytes: Uint8Array,
    header: PlyHeader,
    readonly file: string,
  ) {
    this.#view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.#little = header.encoding === 'little';
    this.#at = header.dataStart;
  }

  next(type: PlyType): number {
    const at = this.#at;
    this.#at = at + PLY_BYTES[type];
    if (this.#at > this.#view.byteLength) throw cutShort(this.file, this.where);
    switch (type) {
      case 'float':
        return this.#view.getFloat32(at, this.#little);
      case 'int':
        return this.#view.getInt32(at, this.#little);
      case 'uchar':
        return this.#view.getUint8(at);
      case 'double':
        return this.#view.getFloat64(at, this.#little);
      case 'uint':
        return this.#view.getUint32(at, this.#little);
      case 'char':
        return this.#view.getInt8(at);
      case 'short':
        return this.#view.getInt16(at, this.#little);
      case 'ushort':
        return this.#view.getUint16(at, this.#little);
    }
  }
  get where(): string {
    return `byte ${Math.min(this.#at, this.#view.byteLength)}`;
  }
}

function cutShort(file: string, where: string): LissomError {
  const message = `${file} ends at ${where}, before everything its header announces. It was cut short: fetch it again.`;
  return new LissomError('file-truncated', message);
}
