// A link of 1.36 kB froze the tab: rows of no numbers cost no bytes, so one table held as many of them as bytes followed,
// and the table could be repeated.

import { expect, test } from 'vitest';
import { MAX_VALUES } from '../../web/recipe/link/errors';
import { decodeLink, encodeLink } from '../../web/recipe/link/link';
import { valuesIn } from '../../web/recipe/link/value';
import { parseRecipe } from '../../web/recipe/parse';
import { refusal } from './bounded';
import { LIST, NUMBERS, sealed, TABLE, tablesOfNothing } from './hostile';

test('rows of no numbers are refused', () => {
  const link = tablesOfNothing();
  expect(link.length).toBeLessThan(4000);
  const { code, message } = refusal('100,000 tables of width 0', () => decodeLink(link));
  expect(code).toBe('link-damaged');
  expect(message).toMatch(/^The link is damaged: .*\.$/);
});

test.each([
  ['numbers', NUMBERS, 0],
  ['rows of one number', TABLE, 1],
])('more %s than a link may hold are refused before they are read', (what, kind, width) => {
  const link = sealed((out) => {
    out.byte(kind);
    out.varint(900_000);
    if (width > 0) out.varint(width);
    out.raw(new Uint8Array(900_002));
  });
  const { code, message } = refusal(`900,000 ${what}`, () => decodeLink(link));
  expect(code).toBe('link-too-large');
  expect(message).toBe(
    'The link holds more than 500,000 values; that many would take 4 MB. Use a project file instead.',
  );
});

test('empty lists within lists count too', () => {
  const link = sealed((out) => {
    out.byte(LIST);
    out.varint(400_000);
    for (let i = 0; i < 400_000; i++) out.raw(Uint8Array.of(LIST, 0));
  });
  expect(refusal('400,000 empty lists', () => decodeLink(link)).code).toBe('link-too-large');
});

test('what cannot be opened is not made: writer and reader count alike', () => {
  const recipe = (points: number) =>
    parseRecipe({
      lissom: 1,
      models: { m: { builtin: 'head-female' } },
      steps: [{ id: 'h', type: 'hair', model: 'm', streams: streams(points) }],
    });
  const streams = (points: number) =>
    Array.from({ length: points / 1000 }, () => ({
      points: Array.from({ length: 1000 }, (_, i) => [i, 1, 2]),
    }));
  // Each point is a row: three numbers and the row itself.
  const most = Math.floor(MAX_VALUES / 9 / 1000) * 1000;
  expect(valuesIn(recipe(most))).toBeLessThan(MAX_VALUES);
  expect(decodeLink(encodeLink(recipe(most)))).toEqual(recipe(most));
  expect(() => encodeLink(recipe(most + 1000))).toThrow(expect.objectContaining({ code: 'link-too-large' }));
});
