import { describe, expect, test } from 'vitest';
import type { Groom } from '../../../web/core/strands';
import { readStrands, writeStrands } from '../../../web/io';
import { codeOf } from '../support';
import { greatestGap, inCentimetres, LOOK, MILLIMETRES, makeGroom } from './support';

const PLAIN = { ...LOOK, colorVariation: 0 };
const withLook = (groom: Groom, look: Groom['strands']['look']): Groom => ({
  ...groom,
  strands: { ...groom.strands, look },
});
const write = (groom: Groom) => writeStrands(groom, 'hair', MILLIMETRES);
const headerOf = (bytes: Uint8Array) => {
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  return {
    magic: String.fromCharCode(...bytes.subarray(0, 4)),
    strands: view.getUint32(4, true),
    points: view.getUint32(8, true),
    arrays: view.getUint32(12, true),
    segments: view.getUint32(16, true),
  };
};

test('strands of one length need no list of segments', () => {
  const file = write(
    withLook(
      makeGroom(5, () => 9),
      PLAIN,
    ),
  );
  expect(headerOf(file)).toEqual({ magic: 'HAIR', strands: 5, points: 45, arrays: 2 | 4, segments: 8 });
  expect(file.length).toBe(128 + 45 * 16);
});

test('strands of several lengths are listed, colours only where they differ', () => {
  const mixed = makeGroom(7, (s) => 2 + s);
  expect(headerOf(write(withLook(mixed, PLAIN)))).toMatchObject({ arrays: 1 | 2 | 4, points: 35 });
  expect(headerOf(write(mixed))).toMatchObject({ arrays: 1 | 2 | 4 | 16 });
  expect(write(mixed).length).toBe(128 + 2 * 7 + 35 * 28);
});

test.each([4, 7])('%i strands come back to the bit, be the numbers aligned or not', (count) => {
  const groom = makeGroom(count, (s) => 3 + (s % 4));
  const { strands, head } = readStrands(write(groom), 'folder/wavy.hair');
  expect(strands.offsets).toEqual(groom.strands.offsets);
  expect(strands.points).toEqual(inCentimetres(groom));
  expect(strands.look.thickness).toBeCloseTo(0.1 * LOOK.thickness, 8);
  expect(strands.look.taper).toBeCloseTo(LOOK.taper, 6);
  expect(head).toBeUndefined();
});

test('one colour comes back as it went', () => {
  const groom = withLook(
    makeGroom(3, () => 4),
    PLAIN,
  );
  expect(readStrands(write(groom), 'a.hair').strands.look.color).toBe(LOOK.color);
});

test('a file within a larger buffer is read from its own beginning', () => {
  const file = write(makeGroom(3, (s) => 2 + s));
  const larger = new Uint8Array(file.length + 3);
  larger.set(file, 3);
  expect(readStrands(larger.subarray(3), 'a.hair')).toEqual(readStrands(file, 'a.hair'));
});

describe('a damaged .hair is refused by name', () => {
  const file = write(makeGroom(7, (s) => 2 + s));
  const withWord = (offset: number, value: number) => {
    const copy = file.slice();
    new DataView(copy.buffer).setUint32(offset, value, true);
    return copy;
  };
  const failing = (bytes: Uint8Array) => codeOf(() => readStrands(bytes, 'a.hair'));

  test('cut anywhere', () => {
    for (let length = 4; length < file.length; length++)
      expect(failing(file.slice(0, length)), `${length} bytes`).toBe('file-truncated');
  });

  test('counts that the file cannot hold, before memory is set aside', () => {
    expect(failing(withWord(8, 4_000_000_000))).toBe('count-too-large');
    expect(failing(withWord(4, 4_000_000_000))).toBe('count-too-large');
  });

  test('strands without points, and counts that contradict each other', () => {
    expect(failing(withWord(12, 1))).toBe('file-damaged');
    expect(failing(withWord(8, 30))).toBe('file-damaged');
    expect(failing(withWord(12, 2))).toBe('file-damaged');
    const none = withWord(4, 0);
    new DataView(none.buffer).setUint32(8, 0, true);
    expect(failing(none)).toBe('no-strands');
  });

  test('strands with a coordinate that is no number are left out', () => {
    const copy = file.slice();
    new DataView(copy.buffer).setFloat32(128 + 14, NaN, true);
    expect(readStrands(copy, 'a.hair').strands.offsets.length).toBe(7);
  });
});

test('a thickness of nothing becomes a usual one', () => {
  const groom = withLook(
    makeGroom(2, () => 5),
    { ...PLAIN, thickness: 0 },
  );
  const { strands } = readStrands(write(groom), 'a.hair');
  expect(strands.look.thickness).toBeGreaterThan(0);
  expect(greatestGap(strands.points, inCentimetres(groom))).toBe(0);
});
