import fc from 'fast-check';
import { expect, test } from 'vitest';
import { LissomError } from '../../web/core/errors';
import { isPng, pngText, withPngText } from '../../web/io/png-text';
import { chunk, PIXEL } from './pixel';

const KEY = 'lissom:recipe';

test('any text comes back out of a picture as it went in', () => {
  fc.assert(
    fc.property(fc.string({ unit: 'grapheme' }), (text) => {
      expect(pngText(withPngText(PIXEL, KEY, text), 'a.png', KEY)).toBe(text);
    }),
    { seed: 7 },
  );
});

test('the picture keeps every chunk of its own, and the new one ends before the end', () => {
  const out = Buffer.from(withPngText(PIXEL, KEY, 'smooth'));
  const added = out.length - PIXEL.length;
  expect(out.subarray(0, PIXEL.length - 12)).toEqual(Buffer.from(PIXEL.subarray(0, -12)));
  expect(out.subarray(-12)).toEqual(Buffer.from(PIXEL.subarray(-12)));
  expect(out.subarray(PIXEL.length - 12, -12)).toEqual(chunk('iTXt', Buffer.from(`${KEY}\0\0\0\0\0smooth`)));
  expect(added).toBe(12 + KEY.length + 5 + 6);
});

test('a second text takes the place of the first, and another keyword is another text', () => {
  const once = withPngText(PIXEL, KEY, 'one');
  const twice = withPngText(withPngText(once, 'Title', 'a head'), KEY, 'two');
  expect(pngText(twice, 'a.png', KEY)).toBe('two');
  expect(pngText(twice, 'a.png', 'Title')).toBe('a head');
  expect(twice.length).toBe(withPngText(once, 'Title', 'a head').length);
});

test('a picture without the text has none', () => {
  expect(isPng(PIXEL)).toBe(true);
  expect(pngText(PIXEL, 'a.png', KEY)).toBeUndefined();
});

test('a picture cut anywhere, or with any byte of its text altered, is refused by name', () => {
  const text = 'curls';
  const whole = withPngText(PIXEL, KEY, text);
  const refused = (bytes: Uint8Array): LissomError => {
    try {
      pngText(bytes, 'a.png', KEY);
    } catch (error) {
      if (error instanceof LissomError) return error;
      throw error;
    }
    throw new Error('was taken');
  };
  for (let end = 0; end < whole.length; end++) {
    const error = refused(whole.subarray(0, end));
    expect(error.code).toBe('picture-damaged');
    expect(error.message).toMatch(/^a\.png is damaged: .*\. Send the picture as a file/);
  }
  const from = whole.length - 12 - 4 - text.length;
  for (let at = from; at < whole.length - 12; at++) {
    const bent = whole.slice();
    bent[at]! ^= 1;
    expect(refused(bent).message, `byte ${at}`).toContain('does not match its check');
  }
});
