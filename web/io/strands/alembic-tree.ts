import { ByteWriter } from '../byte-writer';
import { contentKey, EMPTY_DATA, EMPTY_GROUP, type OgawaWriter, type Ref } from './ogawa';

// Alembic's tree of objects and properties on top of Ogawa (version 1 of the format, one sample of everything).

type Values = Uint8Array | Int8Array | Int16Array | Int32Array | Uint32Array | Float32Array | Float64Array;

/** Numbers of Alembic's plain old data types. */
const POD = { uint8: 1, int16: 4, int32: 6, float32: 10, float64: 11, string: 12 } as const;
type Pod = keyof typeof POD;

const SCALAR = 1;
const ARRAY = 2;
/** An array that is one value in every sample. */
const SINGLE = 3;
const HOMOGENEOUS = 0x400;
const CONSTANT = 0x800;

/** Metadata strings are kept once for the whole file and named by number, from 1; 0 is none. */
export class MetadataList {
  #strings: string[] = [];

  index(text: string): number {
    if (!text) return 0;
    const known = this.#strings.indexOf(text);
    return (known >= 0 ? known : this.#strings.push(text) - 1) + 1;
  }

  bytes(): Uint8Array {
    const out = new ByteWriter();
    for (const text of this.#strings) {
      out.byte(text.length);
      out.text(text);
    }
    return out.finish();
  }
}

interface Closed {
  readonly ref: Ref;
  /** Content of everything inside. */
  readonly key: Uint8Array;
}

/** A compound property under construction: its members in the order they are added. */
export class Compound {
  readonly #file: OgawaWriter;
  readonly #metadata: MetadataList;
  readonly #members: Ref[] = [];
  readonly #headers = new ByteWriter();
  readonly #keys: Uint8Array[] = [];

  constructor(file: OgawaWriter, metadata: MetadataList) {
    this.#file = file;
    this.#metadata = metadata;
  }

  /** One value of `values.length` numbers. */
  scalar(name: string, pod: Pod, values: Values, metadata = ''): void {
    const bytes = bytesOf(values);
    this.#sample(name, SCALAR, pod, pod === 'string' ? 1 : values.length, bytes, metadata, []);
  }

  text(name: string, text: string): void {
    this.scalar(name, 'string', new TextEncoder().encode(`${text}\0`));
  }

  /** A list of entries of `extent` numbers. */
  array(name: string, pod: Pod, values: Values, extent = 1, metadata = ''): void {
    const type = values.length === extent ? SINGLE : ARRAY;
    // The empty block stands for the list's dimensions: one, as long as the bytes say.
    this.#sample(name, type, pod, extent, bytesOf(values), metadata, [EMPTY_DATA]);
  }

  /** A list with the metadata of AbcGeom's geometry parameters. */
  param(name: string, scope: 'con' | 'uni' | 'vtx' | 'fvr', pod: Pod, values: Values, extent = 1): void {
    const keys = [`arrayExtent=1;geoScope=${scope}`];
    // Readers of pairs and triples look for vectors, colours among them.
    if (extent > 1) keys.push('interpretation=vector');
    keys.push(`isGeomParam=true;podExtent=${extent};podName=${pod}_t`);
    this.array(name, pod, values, extent, keys.join(';'));
  }

  compound(name: string, fill: (members: Compound) => void, metadata = ''): void {
    const members = new Compound(this.#file, this.#metadata);
    fill(members);
    const { ref, key } = members.close();
    this.#header(name, this.#metadata.index(metadata) << 20, undefined);
    this.#add(name, ref, key);
  }

  close(): Closed {
    const ref = this.#file.group([...this.#members, this.#file.data(this.#headers.finish())]);
    return { ref, key: contentKey(...this.#keys) };
  }

  #sample(
    name: string,
    type: number,
    pod: Pod,
    extent: number,
    bytes: Uint8Array,
    metadata: string,
    rest: Ref[],
  ): void {
    const key = contentKey(bytes);
    const ref = this.#file.group([this.#file.data(key, bytes), ...rest]);
    const form = type | (POD[pod] << 4) | CONSTANT | (type === SCALAR ? 0 : HOMOGENEOUS);
    this.#header(name, form | (extent << 12) | (this.#metadata.index(metadata) << 20), 1);
    this.#add(name, ref, key);
  }

  #header(name: string, form: number, samples: number | undefined): void {
    this.#headers.u32(form);
    if (samples !== undefined) this.#headers.byte(samples);
    this.#headers.byte(name.length);
    this.#headers.text(name);
  }

  #add(name: string, ref: Ref, key: Uint8Array): void {
    this.#members.push(ref);
    this.#keys.push(new TextEncoder().encode(name), key);
  }
}

export interface AbcObject {
  readonly name: string;
  readonly metadata: string;
  readonly properties: (members: Compound) => void;
}

/** The group of an object without properties whose children have none themselves: the top of a flat scene. */
export function topObject(file: OgawaWriter, metadata: MetadataList, children: readonly AbcObject[]): Ref {
  const headers = new ByteWriter();
  const keys: Uint8Array[] = [];
  const groups = children.map((child) => {
    const properties = new Compound(file, metadata);
    child.properties(properties);
    const { ref, key } = properties.close();
    const name = new TextEncoder().encode(child.name);
    headers.u32(name.length);
    headers.raw(name);
    headers.byte(metadata.index(child.metadata));
    keys.push(name, key);
    return file.group([ref, file.data(key, contentKey())]);
  });
  // Two keys end the headers: of the object's own properties (it has none) and of its children.
  const last = file.data(headers.finish(), contentKey(), contentKey(...keys));
  return file.group([EMPTY_GROUP, ...groups, last]);
}

const bytesOf = (values: Values): Uint8Array =>
  new Uint8Array(values.buffer, values.byteOffset, values.byteLength);
