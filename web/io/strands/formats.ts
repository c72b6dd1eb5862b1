import { LissomError } from '../../core/errors';
import type { Model } from '../../core/model';
import type { Groom } from '../../core/strands';
import { decode } from '../text-scanner';
import { writeAlembic } from './alembic';
import { writeGlb } from './glb';
import { isHair, readHair, writeHair } from './hair';
import { readObjLines, writeObjLines } from './obj-lines';
import { checkOptions, type StrandFormat, type StrandWriteOptions } from './options';
import { writeStrandPly } from './ply';
import { writeUsd } from './usd';

const WRITERS: Readonly<Record<StrandFormat, (groom: Groom, options: StrandWriteOptions) => Uint8Array>> = {
  hair: writeHair,
  usda: writeUsd,
  abc: writeAlembic,
  glb: writeGlb,
  obj: writeObjLines,
  ply: writeStrandPly,
};

/**
 * The bytes of a file of strands, or of cards in their place (`glb`), with the head in the same space wherever the
 * format can hold one. Centimetres, Y up; equal input, equal bytes.
 *
 * @throws LissomError `nothing-to-export`, `option-out-of-range`
 */
export function writeStrands(groom: Groom, format: StrandFormat, options: StrandWriteOptions): Uint8Array {
  checkOptions(options);
  return WRITERS[format](groom, options);
}

const HELP = 'Open a .hair file, or an OBJ with lines (“l”).';

/**
 * Strands of a .hair file or of the lines of an OBJ, in the file's own unit.
 *
 * @param mesh  what `readModel` made of the file, if that is known already
 * @throws LissomError `file-empty`, `file-truncated`, `file-damaged`, `count-too-large`, `no-strands`,
 *                     `format-unsupported`
 */
export function readStrands(bytes: Uint8Array, fileName: string, mesh?: Model): Groom {
  const name = fileName.replace(/^.*[/\\]/, '');
  if (bytes.length === 0)
    throw new LissomError('file-empty', `${name} is empty: 0 bytes. Copy or export it again.`);
  if (isHair(bytes)) return readHair(bytes, name);
  if (isObj(bytes)) return readObjLines(bytes, name, mesh);
  const message = `${name} is in a format whose strands cannot be read here. ${HELP}`;
  throw new LissomError('format-unsupported', message);
}

/** Text with a line that begins as OBJ's do. */
function isObj(bytes: Uint8Array): boolean {
  const head = decode(bytes, 0, Math.min(bytes.length, 1 << 16));
  return !head.includes('\0') && /^[ \t]*(v|vt|vn|o|g|l|f)[ \t]+\S/m.test(head.replace(/\r/g, '\n'));
}
