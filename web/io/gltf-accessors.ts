import { LissomError } from '../core/errors';
import type { Budget } from './budget';
import { entry, type GltfDocument, gltfDamaged, refuseCompressed } from './gltf-document';
import type { GltfAccessor } from './gltf-schema';
import { checkAnnounced } from './reading';

/** Numbers of a value, by its accessor's type. */
export const COMPONENTS: ReadonlyMap<string, number> = new Map([
  ['SCALAR', 1],
  ['VEC2', 2],
  ['VEC3', 3],
  ['VEC4', 4],
  ['MAT4', 16],
]);

export const U8 = 5121;
export const U16 = 5123;
export const U32 = 5125;
export const F32 = 5126;

const BYTES: Readonly<Record<number, number>> = { 5120: 1, [U8]: 1, 5122: 2, [U16]: 2, [U32]: 4, [F32]: 4 };
/** Types that count something: what indices may be written in (glTF 2.0, sections 3.6.2.3 and 3.7.2.1). */
const COUNTING: readonly number[] = [U8, U16, U32];
/** Largest value of each integer type: what normalised values are divided by. */
const LARGEST: Readonly<Record<number, number>> = { 5120: 127, [U8]: 255, 5122: 32767, [U16]: 65535 };

/**
 * The numbers of an accessor, `count × components`, normalised and with sparse values put in.
 *
 * @throws LissomError `file-damaged`, `file-truncated`, `count-too-large`, `file-unfolds-too-far`,
 *                     `format-unsupported` (compressed)
 */
export function readAccessor(doc: GltfDocument, index: number, budget: Budget): Float64Array {
  const accessor = entry(doc, doc.json.accessors, index, 'accessor');
  const { componentType, count, type, sparse } = accessor;
  const components = COMPONENTS.get(type);
  if (!components || !BYTES[componentType] || !(Number.isInteger(count) && count >= 0))
    throw gltfDamaged(doc.file, `accessor ${index} has an unknown type or count`);
  const source = accessor.bufferView === undefined ? undefined : locate(doc, index, accessor, components);
  if (!source) {
    // Zeros by definition: nothing in the file bounds their number, so this does.
    const bytes = doc.buffers.reduce((sum, b) => sum + (b?.length ?? 0), 0);
    checkAnnounced(doc.file, `${count} values`, count, 16 * bytes);
  }
  budget.take(8 * count * components);
  const out = source
    ? readStrided(source, count, components, componentType)
    : new Float64Array(count * components);
  if (sparse) applySparse(doc, out, accessor, components, budget);
  if (accessor.normalized) normalise(out, componentType);
  return out;
}

interface Source {
  readonly view: DataView;
  readonly stride: number;
}

function locate(doc: GltfDocument, index: number, accessor: GltfAccessor, components: number): Source {
  const size = components * BYTES[accessor.componentType]!;
  return locateView(
    doc,
    accessor.bufferView!,
    accessor.byteOffset ?? 0,
    accessor.count,
    size,
    `accessor ${index}`,
  );
}

function locateView(
  doc: GltfDocument,
  viewIndex: number,
  offset: number,
  count: number,
  size: number,
  what: string,
): Source {
  const view = entry(doc, doc.json.bufferViews, viewIndex, 'buffer view');
  const buffer = doc.buffers[view.buffer];
  if (!buffer) throw bufferMissing(doc, view.buffer, view.extensions);
  const start = (view.byteOffset ?? 0) + offset;
  const stride = view.byteStride || size;
  if (!(start >= 0 && stride > 0)) throw gltfDamaged(doc.file, `${what} begins before its buffer`);
  const length = count === 0 ? 0 : stride * (count - 1) + size;
  checkAnnounced(doc.file, `${count} values in ${what}`, start + length, buffer.length);
  // An export copies views whole: what was read beyond one would be lost.
  if (offset + length > view.byteLength)
    throw gltfDamaged(doc.file, `${what} ends beyond its buffer view, which has ${view.byteLength} bytes`);
  return { view: new DataView(buffer.buffer, buffer.byteOffset + start, length), stride };
}

function bufferMissing(doc: GltfDocument, index: number, extensions: object | undefined): LissomError {
  refuseCompressed(Object.keys(extensions ?? {}), doc.file);
  const { uri } = entry(doc, doc.json.buffers, index, 'buffer');
  if (uri === undefined) return gltfDamaged(doc.file, `buffer ${index} is missing`);
  const message =
    `${doc.file} keeps its geometry in another file, “${uri}”, which is not at hand. ` +
    'Export it as a single .glb, which holds everything.';
  return new LissomError('file-incomplete', message);
}

function readStrided(
  { view, stride }: Source,
  count: number,
  components: number,
  type: number,
): Float64Array {
  const out = new Float64Array(count * components);
  const size = BYTES[type]!;
  const get = reader(view, type);
  for (let i = 0, at = 0; i < count; i++)
    for (let k = 0; k < components; k++) out[at++] = get(i * stride + k * size);
  return out;
}

function reader(view: DataView, type: number): (at: number) => number {
  switch (type) {
    case F32:
      return (at) => view.getFloat32(at, true);
    case U32:
      return (at) => view.getUint32(at, true);
    case U16:
      return (at) => view.getUint16(at, true);
    case 5122:
      return (at) => view.getInt16(at, true);
    case U8:
      return (at) => view.getUint8(at);
    default:
      return (at) => view.getInt8(at);
  }
}

function applySparse(
  doc: GltfDocument,
  out: Float64Array,
  accessor: GltfAccessor,
  components: number,
  budget: Budget,
): void {
  const { count, indices, values } = accessor.sparse!;
  if (!COUNTING.includes(indices.componentType))
    throw gltfDamaged(
      doc.file,
      'a sparse accessor counts in a type that has other numbers than whole ones from 0 on',
    );
  const indexSize = BYTES[indices.componentType]!;
  const valueSize = components * BYTES[accessor.componentType]!;
  const at = locateView(doc, indices.bufferView, indices.byteOffset ?? 0, count, indexSize, 'sparse indices');
  const from = locateView(doc, values.bufferView, values.byteOffset ?? 0, count, valueSize, 'sparse values');
  budget.take(8 * count * (1 + components));
  const rows = readStrided(at, count, 1, indices.componentType);
  const replacements = readStrided(from, count, components, accessor.componentType);
  rows.forEach((row, i) => {
    if (row >= accessor.count)
      throw gltfDamaged(doc.file, `a sparse accessor replaces value ${row}, which is missing`);
    out.set(replacements.subarray(i * components, (i + 1) * components), row * components);
  });
}

function normalise(values: Float64Array, type: number): void {
  const largest = LARGEST[type];
  if (largest) for (let i = 0; i < values.length; i++) values[i] = Math.max(values[i]! / largest, -1);
}
