import { LissomError } from '../core/errors';
import type { ModelFormat } from '../core/model';
import { decode } from './text-scanner';

/** The formats that can be read; OFF cannot be written. */
export type FileFormat = ModelFormat | 'off';

/** How the formats are called in sentences. */
export const FORMAT_NAMES: Readonly<Record<FileFormat, string>> = {
  obj: 'OBJ',
  ply: 'PLY',
  stl: 'STL',
  glb: 'GLB',
  gltf: 'glTF',
  off: 'OFF',
};

const HELP = 'Open a model in OBJ, PLY, STL or glTF (.glb).';

/** First bytes of files people drop by mistake, and formats that are meshes but not read here. */
const OTHERS: readonly (readonly [start: string, name: string, mesh: boolean])[] = [
  ['GIF8', 'a GIF picture', false],
  ['\x89PNG', 'a PNG picture', false],
  ['\xff\xd8\xff', 'a JPEG picture', false],
  ['RIFF', 'a picture, sound or film', false],
  ['%PDF', 'a PDF document', false],
  ['PK\x03\x04', 'a zip archive (3MF, USDZ and project files are such)', true],
  ['\x1f\x8b', 'a gzip archive', true],
  ['Kaydara FBX', 'an FBX file', true],
  ['; FBX', 'an FBX file', true],
  ['BLENDER', 'a Blender file', true],
  ['#VRML', 'a VRML file', true],
  ['<?xml', 'an XML document (COLLADA and X3D are such)', true],
  ['<!DOCTYPE', 'a web page', false],
  ['<html', 'a web page', false],
];

/**
 * The format by content first, by extension where the content leaves it open.
 *
 * @throws LissomError `file-empty`, `file-not-a-mesh`, `format-unsupported`, `format-unknown`
 */
export function detectFormat(bytes: Uint8Array, fileName: string): FileFormat {
  if (bytes.length === 0)
    throw new LissomError('file-empty', `${fileName} is empty: 0 bytes. Copy or export it again.`);
  const format = byContent(bytes);
  if (format) return format;
  const start = latin(bytes, 0, 16);
  const other = OTHERS.find(([prefix]) => start.startsWith(prefix));
  if (other) {
    const code = other[2] ? 'format-unsupported' : 'file-not-a-mesh';
    throw new LissomError(code, `${fileName} is ${other[1]}, which cannot be opened here. ${HELP}`);
  }
  const extension = formatOfName(fileName);
  const binary = bytes.subarray(0, 4096).includes(0);
  if (extension === 'stl' || (extension === 'obj' && !binary)) return extension;
  if (extension) {
    const message = `${fileName} is called ${FORMAT_NAMES[extension]}, but its content is not. ${HELP}`;
    throw new LissomError('file-not-a-mesh', message);
  }
  throw new LissomError('format-unknown', `${fileName} is in no format known here. ${HELP}`);
}

/** The format a file name promises. */
export function formatOfName(fileName: string): FileFormat | undefined {
  const extension = /\.([^.]+)$/.exec(fileName)?.[1]?.toLowerCase();
  return extension !== undefined && Object.hasOwn(FORMAT_NAMES, extension)
    ? (extension as FileFormat)
    : undefined;
}

/** A binary STL holds 50 bytes a facet after its count: the sum must come out, whatever the header says. */
export function isBinaryStl(bytes: Uint8Array): boolean {
  if (bytes.length < 84) return false;
  const facets = new DataView(bytes.buffer, bytes.byteOffset).getUint32(80, true);
  return bytes.length === 84 + 50 * facets;
}

function byContent(bytes: Uint8Array): FileFormat | undefined {
  const start = latin(bytes, 0, 16).replace(/^\xef\xbb\xbf/, '');
  if (/^ply[\r\n]/.test(start)) return 'ply';
  if (start.startsWith('glTF')) return 'glb';
  if (isBinaryStl(bytes)) return 'stl';
  if (/^(ST)?C?N?OFF\s/.test(start)) return 'off';
  const head = decode(bytes, 0, Math.min(bytes.length, 1 << 16));
  if (/^\s*solid\b[\s\S]*?\b(facet|endsolid)\b/i.test(head)) return 'stl';
  if (/^\s*\{/.test(head) && /"asset"/.test(decode(bytes))) return 'gltf';
  if (!head.includes('\0') && /^[ \t]*(v|vt|vn|f|o|g|usemtl|mtllib)[ \t]+\S/m.test(head.replace(/\r/g, '\n')))
    return 'obj';
  return undefined;
}

function latin(bytes: Uint8Array, from: number, to: number): string {
  return String.fromCharCode(...bytes.subarray(from, to));
}
