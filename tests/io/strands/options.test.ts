import { describe, expect, test } from 'vitest';
import { LissomError } from '../../../web/core/errors';
import type { Groom } from '../../../web/core/strands';
import { readStrands, type StrandFormat, type StrandWriteOptions, writeStrands } from '../../../web/io';
import { codeOf } from '../support';
import { greatestGap, inCentimetres, MILLIMETRES, makeGroom } from './support';

const FORMATS: StrandFormat[] = ['hair', 'usda', 'abc', 'glb', 'obj', 'ply'];
const GROOM = makeGroom(40, () => 11, { guides: Uint32Array.of(3, 17, 31) });
const hair = (options: Partial<StrandWriteOptions>, groom: Groom = GROOM) =>
  readStrands(writeStrands(groom, 'hair', { ...MILLIMETRES, ...options }), 'a.hair').strands;

test.each(FORMATS)('equal grooms make equal bytes of %s', (format) => {
  const again = makeGroom(40, () => 11, { guides: Uint32Array.of(3, 17, 31) });
  expect(writeStrands(again, format, MILLIMETRES)).toEqual(writeStrands(GROOM, format, MILLIMETRES));
});

test('a share of the strands is the first part of them', () => {
  const part = hair({ strandShare: 0.25 });
  expect(part.offsets.length - 1).toBe(10);
  expect(part.points).toEqual(hair({}).points.slice(0, 10 * 33));
  expect(hair({ strandShare: 0.001 }).offsets.length - 1).toBe(1);
});

test('thinned strands keep root and tip, and every point between is one of theirs', () => {
  const whole = hair({});
  for (const pointStride of [2, 3, 4, 10, 99]) {
    const thin = hair({ pointStride });
    const kept = Math.ceil(10 / pointStride) + 1;
    expect(thin.offsets[1]).toBe(kept);
    for (let k = 0; k < kept; k++) {
      const from = 3 * Math.min(10, k * pointStride);
      expect(thin.points.slice(3 * k, 3 * k + 3)).toEqual(whole.points.slice(from, from + 3));
    }
  }
});

test('guides alone are the strands they name, or evenly chosen ones', () => {
  const whole = hair({}).points;
  const guides = hair({ guidesOnly: true });
  expect(guides.points).toEqual(
    Float32Array.from([3, 17, 31].flatMap((s) => [...whole.slice(33 * s, 33 * s + 33)])),
  );
  const { guides: _, ...none } = makeGroom(400, () => 5);
  expect(hair({ guidesOnly: true }, none).offsets.length - 1).toBe(8);
});

test('a groom whose up is z is laid on its back, strands and head alike', () => {
  const tilted: Groom = { ...GROOM, head: { ...GROOM.head!, upAxis: 'z' } };
  const { strands, head } = readStrands(writeStrands(tilted, 'obj', MILLIMETRES), 'a.obj');
  const straight = inCentimetres(GROOM);
  const turned = straight.map((_, i) => [straight[i], straight[i + 1], -straight[i - 1]!][i % 3]!);
  expect(greatestGap(strands.points, turned)).toBeLessThan(3e-6);
  const [x, y, z] = GROOM.head!.positions;
  expect(greatestGap(head!.positions.subarray(0, 3), [0.1 * x!, 0.1 * z!, -0.1 * y!])).toBeLessThan(1e-12);
});

test('the origin of the strands is added to every point', () => {
  const moved: Groom = { ...GROOM, strands: { ...GROOM.strands, origin: [1000, -20, 3] } };
  const gap = hair({}, moved).points.map((c, i) => c - hair({}).points[i]! - [100, -2, 0.3][i % 3]!);
  expect(greatestGap(gap, new Float32Array(gap.length))).toBeLessThan(1e-5);
});

describe('what cannot be written is said', () => {
  const failing = (groom: Groom, options: Partial<StrandWriteOptions> = {}) =>
    FORMATS.map((format) => codeOf(() => writeStrands(groom, format, { ...MILLIMETRES, ...options })));
  const all = (code: string) => FORMATS.map(() => code);

  test('a groom without a strand, or of points only, or of numbers that are none', () => {
    expect(failing(makeGroom(0, () => 0))).toEqual(all('nothing-to-export'));
    expect(failing(makeGroom(5, () => 1))).toEqual(all('nothing-to-export'));
    const broken = makeGroom(2, () => 3);
    broken.strands.points.fill(NaN);
    expect(failing(broken)).toEqual(all('nothing-to-export'));
    expect(() => writeStrands(broken, 'abc', MILLIMETRES)).toThrow(
      /wavy has no strand .* Grow the hair first\./,
    );
  });

  test('options out of range', () => {
    for (const options of [
      { strandShare: 0 },
      { strandShare: 1.5 },
      { pointStride: 0 },
      { pointStride: 1.5 },
      { centimetresPerUnit: NaN },
      { centimetresPerUnit: 0 },
    ])
      expect(failing(GROOM, options), JSON.stringify(options)).toEqual(all('option-out-of-range'));
    expect(() => writeStrands(GROOM, 'ply', { centimetresPerUnit: -1 })).toThrow(LissomError);
  });
});

test.each(FORMATS)('a strand without a number and a head without a face leave %s whole', (format) => {
  const groom = makeGroom(4, (s) => [1, 3, 0, 4][s]!);
  const empty = { ...groom.head!, faceOffsets: Uint32Array.of(0), faceVertices: new Uint32Array(0) };
  expect(writeStrands({ ...groom, head: empty }, format, MILLIMETRES)).toEqual(
    writeStrands(groom, format, { ...MILLIMETRES, withHead: false }),
  );
});
