import fc from 'fast-check';
import { expect, test } from 'vitest';
import { ByteWriter } from '../../web/io/byte-writer';
import { TextScanner } from '../../web/io/text-scanner';
import { bytes, text } from './support';

const parse = (word: string) => new TextScanner(bytes(word)).number();

test('every double comes back from its shortest decimal to the bit', () => {
  fc.assert(
    fc.property(fc.double(), (value) => {
      const out = new ByteWriter();
      out.decimal(value);
      return Object.is(parse(text(out.finish())), value);
    }),
  );
});

test('any decimal is rounded as the language rounds it', () => {
  const digits = fc.stringMatching(/^[0-9]{1,25}$/);
  const decimal = fc
    .tuple(
      fc.constantFrom('', '-', '+'),
      digits,
      fc.option(digits),
      fc.option(fc.integer({ min: -340, max: 330 })),
    )
    .map(([s, w, f, e]) => s + w + (f === null ? '' : `.${f}`) + (e === null ? '' : `e${e}`));
  fc.assert(
    fc.property(decimal, (word) => Object.is(parse(word), Number(word))),
    { numRuns: 1000 },
  );
});

test('odd spellings of numbers are understood, other words are NaN', () => {
  expect(['.5', '5.', '+1', '1E3', '-0'].map(parse)).toEqual([0.5, 5, 1, 1000, -0]);
  expect(['inf', '-inf', 'Infinity', '1.#INF', '-1.#INF00'].map(parse)).toEqual([
    Infinity,
    -Infinity,
    Infinity,
    Infinity,
    -Infinity,
  ]);
  for (const word of ['nan', '-nan(ind)', '1.#QNAN', 'abc', '0x10', '1,5', '-', '.', '1e', '1.2.3'])
    expect(parse(word), word).toBeNaN();
});

test('a file that grows past its first buffer keeps every byte', () => {
  const out = new ByteWriter(1);
  const expected: number[] = [];
  for (let i = 0; i < 1000; i++) {
    out.byte(i & 255);
    out.u32(i);
    out.f64(i / 3);
    expected.push(i & 255, i, i / 3);
  }
  out.text('grüße');
  const content = out.finish();
  const view = new DataView(content.buffer);
  const found: number[] = [];
  for (let i = 0; i < 1000; i++)
    found.push(view.getUint8(13 * i), view.getUint32(13 * i + 1, true), view.getFloat64(13 * i + 5, true));
  expect(found).toEqual(expected);
  expect(text(content.subarray(13000))).toBe('grüße');
});
