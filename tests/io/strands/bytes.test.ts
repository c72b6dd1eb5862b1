import fc from 'fast-check';
import { expect, test } from 'vitest';
import { writeStrands } from '../../../web/io';
import { ByteWriter } from '../../../web/io/byte-writer';
import { FixedText, placesFor } from '../../../web/io/strands/fixed-text';
import { text } from '../support';
import { MILLIMETRES, makeGroom } from './support';

const GROOM = makeGroom(20, (s) => 2 + s, { guides: Uint32Array.of(2, 9) });

test('an Alembic file is a tree of blocks that fill it without gap or overlap', () => {
  const file = writeStrands(GROOM, 'abc', MILLIMETRES);
  const view = new DataView(file.buffer);
  const word = (at: number) => Number(view.getBigUint64(at, true));
  expect([...file.subarray(0, 8)]).toEqual([...new TextEncoder().encode('Ogawa'), 0xff, 0, 1]);
  const root = word(8);
  expect(word(root)).toBe(6);
  let covered = 16;
  const walk = (at: number) => {
    const children = word(at);
    covered += 8 + 8 * children;
    for (let i = 0; i < children; i++) {
      const place = Number(BigInt.asUintN(63, view.getBigUint64(at + 8 + 8 * i, true)));
      const isData = view.getUint8(at + 15 + 8 * i) >= 128;
      if (place === 0) continue;
      // What a group names lies before it, so the walk ends.
      expect(place).toBeLessThan(at);
      if (isData) covered += 8 + word(place);
      else walk(place);
    }
  };
  walk(root);
  expect(covered).toBe(file.length);
});

test('equal arrays have equal keys in Alembic, different arrays different ones', () => {
  const keyOfPoints = (groom: typeof GROOM) => {
    const file = writeStrands(groom, 'abc', { ...MILLIMETRES, withHead: false });
    const size = groom.strands.points.length * 4 + 16;
    const view = new DataView(file.buffer);
    for (let at = 16; at < file.length - 8; at++)
      if (view.getUint32(at, true) === size && view.getUint32(at + 4, true) === 0)
        return [...file.subarray(at + 8, at + 24)];
    return undefined;
  };
  const other = makeGroom(20, (s) => 2 + s);
  other.strands.points[100]! += 1;
  expect(keyOfPoints(makeGroom(20, (s) => 2 + s))).toEqual(keyOfPoints(GROOM));
  expect(keyOfPoints(other)).not.toEqual(keyOfPoints(GROOM));
});

test('USD is plain text with a header, closed brackets and no number that is none', () => {
  const usd = text(writeStrands(GROOM, 'usda', MILLIMETRES));
  expect(usd.startsWith('#usda 1.0\n(')).toBe(true);
  for (const [open, close] of ['()', '[]', '{}'] as const)
    expect(usd.split(open!).length).toBe(usd.split(close!).length);
  expect(usd).not.toMatch(/nan|inf|undefined|e[+-]\d/i);
});

test('decimals are within half a unit of their last place, and never longer than needed', () => {
  const value = fc.double({ min: -1e6, max: 1e6, noNaN: true });
  fc.assert(
    fc.property(value, fc.nat(9), (number, places) => {
      const out = new ByteWriter();
      const writer = new FixedText(out);
      writer.decimal(number, places);
      writer.flush();
      const written = text(out.finish());
      expect(written).toMatch(/^-?\d+(\.\d*[1-9])?$/);
      expect(Math.abs(Number(written) - number)).toBeLessThanOrEqual(0.5000001 * 10 ** -places + 1e-9);
    }),
  );
});

test('eight significant digits of the greatest number are enough for single precision', () => {
  for (let greatest = 0.01; greatest < 1e5; greatest *= 1.37)
    expect(0.5 * 10 ** -placesFor(greatest)).toBeLessThanOrEqual(greatest * 2 ** -24);
});

test('text longer than a chunk arrives whole', () => {
  const out = new ByteWriter();
  const writer = new FixedText(out);
  for (let i = 0; i < 30_000; i++) {
    writer.integer(i);
    writer.text(' ');
  }
  writer.text('a'.repeat(100));
  writer.flush();
  const words = text(out.finish()).split(' ');
  expect(words.slice(0, -1).map(Number)).toEqual(Array.from({ length: 30_000 }, (_, i) => i));
  expect(words.at(-1)).toBe('a'.repeat(100));
});
