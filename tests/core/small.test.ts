import fc from 'fast-check';
import { expect, test } from 'vitest';
import { fromBase64Url, toBase64Url } from '../../web/core/base64url';
import { crc32 } from '../../web/core/crc32';
import { fromDecimal, numerator, roundTo } from '../../web/core/decimal';
import { Lru } from '../../web/core/lru';
import { firstOutside, fromIndices, toIndices } from '../../web/core/vertex-set';

fc.configureGlobal({ seed: 20070316 });

test('base64url gives any bytes back and writes what Node writes', () => {
  fc.assert(
    fc.property(fc.uint8Array({ maxLength: 50 }), (bytes) => {
      const text = toBase64Url(bytes);
      expect(text).toBe(Buffer.from(bytes).toString('base64url'));
      expect(fromBase64Url(text)).toEqual(bytes);
    }),
  );
  for (const wrong of ['A', 'AA=', 'A/', 'A+', 'é']) expect(fromBase64Url(wrong)).toBeUndefined();
});

test('the checksum is the CRC-32 of zip and PNG', () => {
  expect(crc32(new TextEncoder().encode('123456789'))).toBe(0xcbf43926);
});

test('a decimal is written as an integer only where that gives it back bit for bit', () => {
  fc.assert(
    fc.property(fc.double({ noNaN: true, noDefaultInfinity: true }), fc.nat(22), (value, places) => {
      const whole = numerator(value, places);
      if (whole !== undefined) expect(fromDecimal(whole, places)).toBe(value);
    }),
  );
  fc.assert(
    fc.property(fc.integer({ min: -(2 ** 45), max: 2 ** 45 }), fc.nat(9), (whole, places) => {
      expect(numerator(whole / 10 ** places, places)).toBe(whole);
    }),
  );
  expect(numerator(-0, 3)).toBeUndefined();
});

test('rounding keeps to its places, is stable and never makes −0', () => {
  expect(roundTo(1.23456789, 3)).toBe(1.235);
  expect(Object.is(roundTo(-0.0001, 3), 0)).toBe(true);
  expect(roundTo(1e300, 6)).toBe(1e300);
  fc.assert(
    fc.property(fc.double({ min: -1e6, max: 1e6, noNaN: true }), (value) => {
      expect(roundTo(roundTo(value, 6), 6)).toBe(roundTo(value, 6));
    }),
  );
});

test('the cache forgets what was used longest ago and says so', () => {
  const gone: string[] = [];
  const cache = new Lru<string>(3, (value) => gone.push(value));
  for (const key of ['a', 'b', 'c']) cache.set(key, key.toUpperCase());
  cache.get('a');
  cache.set('d', 'D');
  expect(gone).toEqual(['B']);
  cache.set('heavy', 'H', 10);
  expect(gone).toEqual(['B', 'C', 'A', 'D']);
  expect(cache.get('heavy')).toBe('H');
});

test('a vertex set keeps its vertices in whatever form is shortest', () => {
  const indices = fc.array(fc.nat(60), { maxLength: 60 });
  fc.assert(
    fc.property(indices, (any) => {
      const sorted = [...new Set(any)].sort((a, b) => a - b);
      expect([...toIndices(fromIndices(any, 61), 61)]).toEqual(sorted);
      expect(firstOutside(fromIndices(any, 1000), 61)).toBeUndefined();
    }),
  );
  expect(firstOutside({ ranges: [[0, 4_000_000_000]] }, 61)).toBe(4_000_000_000);
});
