import { LissomError } from '../core/errors';
import type { FaceGroup, Model } from '../core/model';
import { Budget } from './budget';
import { GrowingFloat64, GrowingUint32 } from './growing';
import { Notes } from './notes';
import { NO_INDEX, type ReadResult } from './reading';
import { TextScanner } from './text-scanner';
import { fromUnitComments } from './units-comment';

/** What an OBJ export puts back: the lines between the faces, and the comments at the head of the file. */
export interface ObjExtra {
  readonly comments: readonly string[];
  /** `o`, `g`, `usemtl`, `s`, `mtllib` lines and the number of faces before each. */
  readonly statements: readonly { readonly face: number; readonly text: string }[];
}

const LOWER_V = 118;
const LOWER_F = 102;
const HASH = 35;
/** Bytes that a line takes which is kept as it is, beside its text: a record, its place in a list. */
const KEPT_LINE = 80;

/**
 * Wavefront OBJ: polygons, texture coordinates per corner, `v x y z r g b` colours, groups and materials by name.
 *
 * Normals are left out (they change with the shape), lines and points too. A coordinate that is no number
 * becomes NaN and an index that names no vertex stays one, for the kernel to report.
 *
 * @throws LissomError `file-not-a-mesh` without a single vertex; `file-too-large`, `file-unfolds-too-far`
 */
export function readObj(bytes: Uint8Array, name: string): ReadResult {
  const reader = new ObjReader(bytes, new Budget('mesh', name, bytes.length));
  reader.read();
  return { model: reader.model(name), notes: reader.notes.list() };
}

class ObjReader {
  readonly notes = new Notes();
  readonly #text: TextScanner;
  readonly #budget: Budget;
  readonly #positions: GrowingFloat64;
  readonly #colors: GrowingFloat64;
  #colorAlpha = false;
  readonly #uvs: GrowingFloat64;
  readonly #faceOffsets: GrowingUint32;
  readonly #faceVertices: GrowingUint32;
  readonly #uvIndices: GrowingUint32;
  #hasUvIndices = false;
  #comments: string[] = [];
  #statements: { face: number; text: string }[] = [];
  #groups = new GroupRuns();
  #numbers = new Float64Array(8);

  constructor(bytes: Uint8Array, budget: Budget) {
    this.#text = new TextScanner(bytes, 0, true);
    this.#budget = budget;
    this.#positions = new GrowingFloat64(budget);
    this.#colors = new GrowingFloat64(budget);
    this.#uvs = new GrowingFloat64(budget);
    this.#faceOffsets = new GrowingUint32(budget);
    this.#faceVertices = new GrowingUint32(budget);
    this.#uvIndices = new GrowingUint32(budget);
    this.#faceOffsets.push(0);
  }

  read(): void {
    const text = this.#text;
    while (text.toNextWord()) {
      const c = text.bytes[text.at];
      const next = text.bytes[text.at + 1];
      const single = next === 32 || next === 9;
      if (c === LOWER_V && single) this.#vertex();
      else if (c === LOWER_F && single) this.#face();
      else if (c === HASH) this.#comment();
      else this.#other();
      text.nextLine();
    }
  }

  model(name: string): Model {
    const vertices = this.#positions.length / 3;
    if (vertices === 0) {
      const message = `${name} holds no vertex: no line of it begins with “v”. Open a model in OBJ, PLY, STL or glTF.`;
      throw new LissomError('file-not-a-mesh', message);
    }
    if (this.#faces === 0)
      this.notes.add(
        'no-faces',
        `${name} holds points but no faces: a surface is drawn through them to work on.`,
      );
    const { units, others } = fromUnitComments(this.#comments);
    const groups = this.#groups.finish(this.#faces);
    const extra: ObjExtra = { comments: others, statements: this.#statements };
    return {
      name,
      positions: this.#positions.finish(),
      faceOffsets: this.#faceOffsets.finish(),
      faceVertices: this.#faceVertices.finish(),
      ...(this.#colors.length > 0 && { colors: this.#finishColors(vertices), colorAlpha: this.#colorAlpha }),
      ...(this.#hasUvIndices && { uvs: this.#uvs.finish(), uvIndices: this.#finishUvIndices() }),
      ...(groups.length > 0 && { groups }),
      ...units,
      origin: { format: 'obj', extra },
    };
  }

  get #faces(): number {
    return this.#faceOffsets.length - 1;
  }

  #vertex(): void {
    const count = this.#readNumbers(7);
    const [x, y, z] = this.#numbers;
    if (count < 3)
      this.notes.add('coordinate-missing', 'A vertex has fewer than three coordinates.', this.#here());
    this.#positions.push(x as number);
    this.#positions.push(count > 1 ? (y as number) : NaN);
    this.#positions.push(count > 2 ? (z as number) : NaN);
    if (count >= 6) this.#color(count);
  }

  #color(count: number): void {
    const white = this.#positions.length / 3 - 1;
    while (this.#colors.length < 4 * white) this.#colors.push(NaN);
    for (let k = 3; k < 6; k++) this.#colors.push(this.#numbers[k]!);
    this.#colors.push(count > 6 ? this.#numbers[6]! : 1);
    if (count > 6) this.#colorAlpha = true;
  }

  #face(): void {
    const text = this.#text;
    text.at++;
    const vertices = this.#positions.length / 3;
    const uvs = this.#uvs.length / 2;
    const first = this.#faceVertices.length;
    while (!text.atLineEnd()) {
      this.#faceVertices.push(resolve(text.integer(), vertices));
      let uv = NO_INDEX;
      if (text.slash()) {
        const c = text.bytes[text.at] as number;
        if (c === 45 || c === 43 || (c >= 48 && c <= 57)) {
          uv = resolve(text.integer(), uvs);
          this.#hasUvIndices = true;
        }
        if (text.slash()) text.word();
      }
      this.#uvIndices.push(uv);
    }
    if (this.#faceVertices.length - first < 3) {
      this.notes.add('face-too-short', 'A face with fewer than three corners was left out.', this.#here());
      this.#faceVertices.length = first;
      this.#uvIndices.length = first;
    } else this.#faceOffsets.push(this.#faceVertices.length);
  }

  #comment(): void {
    if (this.#positions.length > 0) return;
    this.#budget.take(KEPT_LINE);
    this.#comments.push(this.#text.restOfLine().replace(/^#+ ?/, ''));
  }

  #other(): void {
    const text = this.#text;
    const where = this.#here();
    const keyword = text.word();
    switch (keyword) {
      case 'vt': {
        const count = this.#readNumbers(2, false);
        this.#uvs.push(count > 0 ? this.#numbers[0]! : 0);
        this.#uvs.push(count > 1 ? this.#numbers[1]! : 0);
        return;
      }
      case 'vn':
        return;
      case 'o':
      case 'g':
      case 'usemtl':
      case 's':
      case 'mtllib': {
        this.#budget.take(KEPT_LINE);
        const value = text.restOfLine();
        this.#statements.push({ face: this.#faces, text: `${keyword} ${value}`.trimEnd() });
        if (keyword === 'o' || keyword === 'g' || keyword === 'usemtl')
          this.#groups.change(this.#faces, keyword, value);
        return;
      }
      case 'l':
      case 'p':
        this.notes.add(
          'lines-left-out',
          'Lines and single points were left out: only faces are used.',
          where,
        );
        return;
      default:
        this.notes.add(
          'statement-ignored',
          `A line that is no part of a mesh was passed over: “${keyword}”.`,
          where,
        );
    }
  }

  /** Reads up to `most` numbers of this line into `#numbers`; how many there were. */
  #readNumbers(most: number, afterKeyword = true): number {
    const text = this.#text;
    if (afterKeyword) text.at++;
    let count = 0;
    while (count < most && !text.atLineEnd()) {
      const start = text.at;
      const value = text.number();
      this.#numbers[count++] = value;
      if (Number.isNaN(value) && !isNan(text.bytes, start))
        this.notes.add(
          'number-unreadable',
          'A number could not be read and counts as missing.',
          this.#here(),
        );
    }
    return count;
  }

  #here(): string {
    return `line ${this.#text.line}`;
  }

  #finishColors(vertices: number): Uint8Array {
    const colors = this.#colors.finish();
    const scale = colors.some((c) => c > 1) ? 1 : 255;
    const out = new Uint8ClampedArray(4 * vertices).fill(255);
    for (let i = 0; i < colors.length; i++) {
      const unset = Number.isNaN(colors[i]) || (i % 4 === 3 && !this.#colorAlpha);
      if (!unset) out[i] = colors[i]! * scale;
    }
    return new Uint8Array(out.buffer);
  }

  #finishUvIndices(): Uint32Array {
    const indices = this.#uvIndices.finish();
    const count = this.#uvs.length / 2;
    for (let i = 0; i < indices.length; i++) {
      if (indices[i] === NO_INDEX || indices[i]! < count) continue;
      indices[i] = NO_INDEX;
      this.notes.add(
        'texture-index-out-of-range',
        'Corners that name a missing texture coordinate have none.',
      );
    }
    return indices;
  }
}

/** Runs of faces between changes of object, group and material. */
class GroupRuns {
  #runs: FaceGroup[] = [];
  #start = 0;
  #current = { o: '', g: '', usemtl: '' };

  change(face: number, keyword: 'o' | 'g' | 'usemtl', value: string): void {
    this.#close(face);
    if (keyword === 'o') this.#current.g = '';
    this.#current[keyword] = value;
  }

  finish(faces: number): readonly FaceGroup[] {
    this.#close(faces);
    return this.#runs;
  }

  #close(end: number): void {
    const { o, g, usemtl } = this.#current;
    if (end > this.#start && (o || g || usemtl))
      this.#runs.push({ name: g || o, ...(usemtl && { material: usemtl }), start: this.#start, end });
    this.#start = end;
  }
}

/** OBJ counts from 1, or back from the newest with −1. */
function resolve(index: number, count: number): number {
  const resolved = index > 0 ? index - 1 : index < 0 ? count + index : NO_INDEX;
  return resolved >= 0 && resolved < NO_INDEX ? resolved : NO_INDEX;
}

const isNan = (bytes: Uint8Array, at: number): boolean => {
  const c = bytes[bytes[at] === 45 || bytes[at] === 43 ? at + 1 : at] as number;
  return (c | 32) === 110 || (c === 49 && bytes.indexOf(35, at) === at + 2);
};
