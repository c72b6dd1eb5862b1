import { LissomError } from '../core/errors';
import type { Model } from '../core/model';
import type { Budget } from './budget';
import { GrowingFloat64, GrowingUint32 } from './growing';
import type { Notes } from './notes';
import type { PlyElement, PlyType } from './ply-header';
import type { PlyValues } from './ply-values';
import type { PlyColumn } from './ply-vertices';
import { NO_INDEX } from './reading';

const INDEX_LISTS = new Set(['vertex_indices', 'vertex_index', 'vertex_indexes']);

/** Whether rows of this element name vertices. */
export const namesVertices = ({ properties }: PlyElement): boolean =>
  properties.some((p) => p.countType && INDEX_LISTS.has(p.name));

type PerFace = Pick<Model, 'faceOffsets' | 'faceVertices' | 'uvs' | 'uvIndices'>;

/** Gathers the faces of a PLY: polygons with their corners' texture coordinates, or triangle strips. */
export class PlyFaces {
  readonly #offsets: GrowingUint32;
  readonly #vertices: GrowingUint32;
  readonly #uvs: GrowingFloat64;
  readonly #uvIndices: GrowingUint32;
  #columns: PlyColumn[] = [];

  constructor(
    readonly file: string,
    readonly notes: Notes,
    private readonly budget: Budget,
  ) {
    this.#offsets = new GrowingUint32(budget);
    this.#vertices = new GrowingUint32(budget);
    this.#uvs = new GrowingFloat64(budget);
    this.#uvIndices = new GrowingUint32(budget);
    this.#offsets.push(0);
  }

  get count(): number {
    return this.#offsets.length - 1;
  }

  read(values: PlyValues, { count, properties }: PlyElement): void {
    const columns = new Map<string, PlyColumn>();
    const before = this.count;
    this.budget.take(8 * count * properties.filter(({ countType }) => !countType).length);
    for (const { name, type, countType } of properties)
      if (!countType) columns.set(name, { name, type, values: new Float64Array(count) });
    const corners: number[] = [];
    const wedges: number[] = [];
    const unused: number[] = [];
    for (let row = 0; row < count; row++) {
      corners.length = 0;
      wedges.length = 0;
      const kept = this.count - before;
      for (const { name, type, countType } of properties) {
        if (countType) {
          const list = INDEX_LISTS.has(name) ? corners : name === 'texcoord' ? wedges : unused;
          this.#list(values, countType, type, list);
        } else columns.get(name)!.values[kept] = values.next(type);
      }
      this.#polygon(corners, wedges, row);
    }
    // Columns of a second face element, or of one mixed with strips, would have no clear row.
    const kept = this.count - before;
    if (before === 0)
      this.#columns = [...columns.values()].map((c) => ({ ...c, values: c.values.slice(0, kept) }));
  }

  /** Stanford's strips: every corner from the third on makes a triangle with the two before; −1 starts anew. */
  readStrips(values: PlyValues, { count, properties }: PlyElement): void {
    const strip: number[] = [];
    for (let row = 0; row < count; row++)
      for (const { name, type, countType } of properties) {
        if (!countType) values.next(type);
        else {
          this.#list(values, countType, type, strip);
          if (INDEX_LISTS.has(name)) this.#strip(strip);
        }
      }
    this.notes.add(
      'strips-unfolded',
      `The triangle strips of ${this.file} were unfolded into single triangles.`,
    );
  }

  finish(): PerFace & { faceColumns: readonly PlyColumn[] } {
    const hasUvs = this.#uvs.length > 0;
    return {
      faceOffsets: this.#offsets.finish(),
      faceVertices: this.#vertices.finish(),
      ...(hasUvs && { uvs: this.#uvs.finish(), uvIndices: this.#uvIndices.finish() }),
      faceColumns: this.#columns.filter((column) => column.values.length === this.count),
    };
  }

  #list(values: PlyValues, countType: PlyType, type: PlyType, out: number[]): void {
    const length = values.next(countType);
    if (!(length >= 0)) {
      const message =
        `${this.file} makes no sense at ${values.where}: a list of ${length} values. ` +
        'Export the model again from the program that made it.';
      throw new LissomError('file-damaged', message);
    }
    out.length = 0;
    for (let i = 0; i < length; i++) out.push(values.next(type));
  }

  #polygon(corners: readonly number[], wedges: readonly number[], row: number): void {
    if (corners.length < 3) {
      this.notes.add('face-too-short', 'A face with fewer than three corners was left out.', `face ${row}`);
      return;
    }
    const hasUvs = wedges.length === 2 * corners.length;
    for (let i = 0; i < corners.length; i++) {
      this.#vertices.push(toIndex(corners[i]!));
      this.#uvIndices.push(hasUvs ? this.#uvs.length / 2 : NO_INDEX);
      if (!hasUvs) continue;
      this.#uvs.push(wedges[2 * i]!);
      this.#uvs.push(wedges[2 * i + 1]!);
    }
    this.#offsets.push(this.#vertices.length);
  }

  #strip(strip: readonly number[]): void {
    let start = 0;
    for (let i = 0; i < strip.length; i++) {
      const c = strip[i]!;
      if (c < 0 || c === NO_INDEX) start = i + 1;
      if (i < start + 2) continue;
      const [a, b] = [strip[i - 2]!, strip[i - 1]!];
      // Repeated corners only stitch strips together.
      if (a === b || b === c || c === a) continue;
      this.#polygon((i - start) % 2 === 0 ? [a, b, c] : [b, a, c], [], 0);
    }
  }
}

/** Indices stay as the file has them, −1 as the largest: what names no vertex is the kernel's to report. */
function toIndex(value: number): number {
  return value >= -0x80000000 && value <= NO_INDEX ? value >>> 0 : NO_INDEX;
}
