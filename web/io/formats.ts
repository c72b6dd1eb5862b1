import { LissomError } from '../core/errors';
import { type Model, type ModelFormat, vertexCount } from '../core/model';
import { detectFormat, type FileFormat, FORMAT_NAMES, formatOfName } from './detect';
import { readGltf } from './gltf-read';
import { writeGltf } from './gltf-write';
import { readObj } from './obj-read';
import { writeObj } from './obj-write';
import { readOff } from './off';
import { readPly } from './ply-read';
import { writePly } from './ply-write';
import type { ReadResult } from './reading';
import { readStl, writeStl } from './stl';

/**
 * Reads a model in any known format, by content before extension.
 *
 * @param fileName  with or without folder; the model's name is the part after it
 * @throws LissomError `file-empty`, `file-truncated`, `file-damaged`, `file-incomplete`, `file-not-a-mesh`,
 *                     `count-too-large`, `face-too-large`, `format-unknown`,
 *                     `format-unsupported`
 */
export function readModel(bytes: Uint8Array, fileName: string): ReadResult {
  const name = fileName.replace(/^.*[/\\]/, '');
  const format = detectFormat(bytes, name);
  const { model, notes } = readAs(format, bytes, name);
  if (vertexCount(model) === 0) {
    const message = `${name} holds no vertex, so it holds no model. Open another file.`;
    throw new LissomError('file-not-a-mesh', message);
  }
  checkCorners(model, name);
  const promised = formatOfName(name);
  if (promised === undefined || promised === format) return { model, notes };
  const message = `${name} is called ${FORMAT_NAMES[promised]}, but it is ${FORMAT_NAMES[format]} and was read as such.`;
  return {
    model,
    notes: [{ code: 'extension-differs', count: 1, examples: [], repaired: true, message }, ...notes],
  };
}

/** Every face is cut into triangles before it is drawn or solved for, which takes a second for so many. */
const MOST_CORNERS = 100_000;

function checkCorners({ faceOffsets }: Model, name: string): void {
  for (let f = 1; f < faceOffsets.length; f++) {
    const corners = faceOffsets[f]! - faceOffsets[f - 1]!;
    if (corners <= MOST_CORNERS) continue;
    const [count, most] = [corners, MOST_CORNERS].map((n) => n.toLocaleString('en-US'));
    const message = `${name}: face ${f} has ${count} corners; the limit is ${most}. Cut it into smaller faces.`;
    throw new LissomError('face-too-large', message);
  }
}

function readAs(format: FileFormat, bytes: Uint8Array, name: string): ReadResult {
  switch (format) {
    case 'obj':
      return readObj(bytes, name);
    case 'ply':
      return readPly(bytes, name);
    case 'stl':
      return readStl(bytes, name);
    case 'off':
      return readOff(bytes, name);
    case 'glb':
    case 'gltf':
      return readGltf(bytes, name, format === 'glb');
  }
}

export interface WriteOptions {
  /** PLY and STL as text instead of binary. */
  readonly ascii?: boolean;
}

/** The bytes of a file in `format`, with the model's vertex order, polygons, colours, uvs and names. @throws LissomError `nothing-to-export` */
export function writeModel(model: Model, format: ModelFormat, options: WriteOptions = {}): Uint8Array {
  switch (format) {
    case 'obj':
      return writeObj(model);
    case 'ply':
      return writePly(model, options.ascii);
    case 'stl':
      return writeStl(model, options.ascii);
    case 'glb':
    case 'gltf':
      return writeGltf(model, format);
  }
}
