import { LissomError } from '../../core/errors';
import type { Groom } from '../../core/strands';
import { Budget } from '../budget';
import { ByteWriter } from '../byte-writer';
import { checkAnnounced } from '../reading';
import { toSrgb } from '../srgb';
import { type Curves, curveCount, curvesToWrite, pointCount } from './curves';
import { linearColor } from './look';
import type { StrandWriteOptions } from './options';
import { groomOf } from './read-groom';

// Cem Yuksel's .hair: a header of 128 bytes, then only those arrays whose bit is set, little endian.

const HEADER = 128;
const SEGMENTS = 1;
const POINTS = 2;
const THICKNESS = 4;
const TRANSPARENCY = 8;
const COLORS = 16;
/** Segments of a strand are counted in 16 bits. */
export const MOST_POINTS = 65536;

/** The strands with their diameters, and colours where they differ. A .hair file has no place for a head. */
export function writeHair(groom: Groom, options: StrandWriteOptions): Uint8Array {
  const curves = curvesToWrite(groom, options, MOST_POINTS);
  const { colorVariation, color, thickness } = groom.strands.look;
  const count = curveCount(curves);
  const segments = segmentsOf(curves);
  const equal = segments.every((n) => n === segments[0]);
  const out = new ByteWriter(HEADER + 2 * count + (16 + (colorVariation > 0 ? 12 : 0)) * pointCount(curves));
  out.text('HAIR');
  out.u32(count);
  out.u32(pointCount(curves));
  out.u32((equal ? 0 : SEGMENTS) | POINTS | THICKNESS | (colorVariation > 0 ? COLORS : 0));
  out.u32(equal ? segments[0]! : 0);
  out.f32(thickness * options.centimetresPerUnit);
  out.f32(0);
  for (const level of linearColor(color)) out.f32(toSrgb(level) / 255);
  out.text('Lissom: centimetres, Y up');
  while (out.length < HEADER) out.byte(0);
  if (!equal) out.raw(bytesOf(segments));
  out.raw(bytesOf(curves.points));
  out.raw(bytesOf(curves.widths));
  if (colorVariation > 0) out.raw(bytesOf(colorsPerPoint(curves)));
  return out.finish();
}

function segmentsOf({ offsets }: Curves): Uint16Array {
  return Uint16Array.from({ length: offsets.length - 1 }, (_, i) => offsets[i + 1]! - offsets[i]! - 1);
}

function colorsPerPoint(curves: Curves): Float32Array {
  const { offsets, colors } = curves;
  const out = new Float32Array(3 * pointCount(curves));
  for (let i = 0; i < curveCount(curves); i++) {
    const rgb = [0, 1, 2].map((k) => toSrgb(colors[3 * i + k]!) / 255);
    for (let p = offsets[i]!; p < offsets[i + 1]!; p++) out.set(rgb, 3 * p);
  }
  return out;
}

export const isHair = (bytes: Uint8Array): boolean =>
  bytes[0] === 72 && bytes[1] === 65 && bytes[2] === 73 && bytes[3] === 82;

/** @throws LissomError `file-truncated`, `count-too-large`, `file-damaged`, `no-strands`, `file-too-large` */
export function readHair(bytes: Uint8Array, name: string): Groom {
  const budget = new Budget('strands', name, bytes.length);
  checkAnnounced(name, 'a header', HEADER, bytes.length);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const [count, total, arrays] = [view.getUint32(4, true), view.getUint32(8, true), view.getUint32(12, true)];
  if (!(arrays & POINTS)) throw damaged(name, 'it says that it holds no points');
  const perPoint =
    12 + (arrays & THICKNESS ? 4 : 0) + (arrays & TRANSPARENCY ? 4 : 0) + (arrays & COLORS ? 12 : 0);
  const needed = HEADER + (arrays & SEGMENTS ? 2 * count : 0) + perPoint * total;
  checkAnnounced(name, `${count} strands of ${total} points`, needed, bytes.length);
  // Without a list every strand has the same length, so the counts bound each other.
  const common = view.getUint32(16, true);
  if (!(arrays & SEGMENTS) && count * (common + 1) !== total)
    throw damaged(name, `${count} strands of ${common} segments do not make ${total} points`);

  budget.take(4 * (count + 1) + 2 * perPoint * total);
  const offsets = new Uint32Array(count + 1);
  let points = 0;
  for (let i = 0; i < count; i++) {
    points += 1 + (arrays & SEGMENTS ? view.getUint16(HEADER + 2 * i, true) : common);
    offsets[i + 1] = points;
  }
  if (points !== total)
    throw damaged(name, `its strands have ${points} points together, but it announces ${total}`);

  let at = HEADER + (arrays & SEGMENTS ? 2 * count : 0);
  // The arrays need not begin where single-precision numbers can be viewed in place.
  const floats = (length: number): Float32Array => {
    const copy = bytes.slice(at, at + 4 * length);
    at += 4 * length;
    return new Float32Array(copy.buffer, 0, length);
  };
  const coordinates = floats(3 * total);
  const widths = arrays & THICKNESS ? floats(total) : undefined;
  if (arrays & TRANSPARENCY) at += 4 * total;
  const colors = arrays & COLORS ? floats(3 * total) : undefined;
  const rgb = [28, 32, 36].map((offset) => view.getFloat32(offset, true));
  return groomOf(name, {
    offsets,
    points: coordinates,
    widths,
    colors,
    width: view.getFloat32(20, true),
    color: rgb,
  });
}

function damaged(name: string, what: string): LissomError {
  const message = `${name} is damaged: ${what}. Export it again from the program that made it.`;
  return new LissomError('file-damaged', message);
}

const bytesOf = (values: Float32Array | Uint16Array): Uint8Array =>
  new Uint8Array(values.buffer, values.byteOffset, values.byteLength);
