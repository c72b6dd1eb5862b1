import fc from 'fast-check';
import { expect, test } from 'vitest';
import { Hasher, hashValue } from '../../web/core/hash';

fc.configureGlobal({ seed: 20070316 });

const hashBytes = (view: ArrayBufferView) => new Hasher().bytes(view).digest();

test('equal content has an equal key, wherever it lies in memory', () => {
  fc.assert(
    fc.property(fc.uint8Array({ maxLength: 64 }), fc.nat(7), (bytes, offset) => {
      const elsewhere = new Uint8Array(bytes.length + offset).subarray(offset);
      elsewhere.set(bytes);
      expect(hashBytes(elsewhere)).toBe(hashBytes(bytes));
    }),
  );
});

test('one changed bit anywhere changes the key', () => {
  const data = Float64Array.from({ length: 40 }, (_, i) => i / 7);
  const keys = new Set([hashBytes(data)]);
  for (let bit = 0; bit < data.byteLength * 8; bit++) {
    const changed = data.slice();
    new Uint8Array(changed.buffer)[bit >> 3]! ^= 1 << (bit & 7);
    keys.add(hashBytes(changed));
  }
  expect(keys.size).toBe(data.byteLength * 8 + 1);
});

test('each of the four words of a key tells inputs apart on its own', () => {
  const words = Array.from({ length: 4 }, () => new Set<string>());
  for (let n = 0; n < 3000; n++) {
    const key = hashValue(n);
    for (const [at, seen] of words.entries()) seen.add(key.slice(8 * at, 8 * at + 8));
  }
  // Of 3,000 random words of 32 bits about one pair in a thousand such sets would coincide.
  for (const seen of words) expect(seen.size).toBeGreaterThanOrEqual(2999);
});

test('order of fields does not count, order of items does, and shapes do not run together', () => {
  expect(hashValue({ a: 1, b: 2, c: undefined })).toBe(hashValue({ b: 2, a: 1 }));
  const all = [
    [1, 2],
    [2, 1],
    [[1], 2],
    [1, [2]],
    '12',
    ['12'],
    ['1', '2'],
    {},
    [],
    null,
    false,
    true,
    0,
    -0,
    '',
    { a: '' },
  ];
  expect(new Set(all.map(hashValue)).size).toBe(all.length);
});

test('a key is 32 hexadecimal digits', () => {
  expect(hashValue('anything')).toMatch(/^[0-9a-f]{32}$/);
});
