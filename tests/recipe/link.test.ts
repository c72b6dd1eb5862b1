import fc from 'fast-check';
import { deflateSync } from 'fflate';
import { describe, expect, test } from 'vitest';
import { fromBase64Url, toBase64Url } from '../../web/core/base64url';
import { crc32 } from '../../web/core/crc32';
import { LissomError } from '../../web/core/errors';
import { ByteReader, ByteWriter } from '../../web/recipe/link/bytes';
import { decodeLink, encodeLink, hasLink } from '../../web/recipe/link/link';
import { readValue, writeValue } from '../../web/recipe/link/value';
import { parseRecipe } from '../../web/recipe/parse';
import { anyNumber, anyRecipe, example } from './arbitraries';

const recipe = parseRecipe(example());
const link = encodeLink(recipe, 'https://example.org/app/');
const payload = link.split('#r=')[1]!;

function refusal(address: string): LissomError {
  try {
    decodeLink(address);
  } catch (error) {
    expect(error).toBeInstanceOf(LissomError);
    return error as LissomError;
  }
  throw new Error('the link was accepted');
}

describe('a round trip', () => {
  test('gives any recipe back to the last bit, and the same link again', () => {
    fc.assert(
      fc.property(anyRecipe, (any) => {
        const made = encodeLink(any);
        const back = decodeLink(made);
        expect(back).toStrictEqual(any);
        expect(encodeLink(back)).toBe(made);
      }),
    );
  });

  test('gives any JSON value back, known to a schema or not', () => {
    const points = fc.array(fc.tuple(anyNumber, anyNumber, anyNumber), { maxLength: 20 });
    const value = fc.oneof(
      fc.jsonValue().map((held) => JSON.parse(JSON.stringify(held))),
      points,
      anyNumber,
    );
    fc.assert(
      fc.property(value, (any) => {
        const out = new ByteWriter();
        writeValue(out, any);
        const from = new ByteReader(out.done());
        expect(readValue(from)).toStrictEqual(any);
        expect(from.left).toBe(0);
      }),
    );
  });

  test('bears what chats and mail programs do to a link', () => {
    const broken = `${link.slice(0, 60)}\n  ${link.slice(60)}`;
    for (const given of [
      link,
      `#r=${payload}`,
      `r=${payload}`,
      `${link}.`,
      `${link})`,
      `${link}&x=1`,
      ` ${link} `,
      broken,
    ])
      expect(decodeLink(given)).toStrictEqual(recipe);
  });
});

describe('length', () => {
  test('the example is a short link', () => {
    expect(link.length).toBeLessThan(260);
  });

  test('30 strokes of 12 points on a grid of 1/1000 fit a chat message', () => {
    // Smooth curves over a head, as strokes are once fitted and quantised.
    const stroke = (k: number) =>
      Array.from({ length: 12 }, (_, i) => {
        const [a, r] = [k * 0.21, 9 + i * 0.45];
        const at = [r * Math.cos(a + i * 0.05), 12 - i * i * 0.11, r * Math.sin(a + i * 0.05)];
        return at.map((x) => Math.round(x * 1000) / 1000);
      });
    const hair = { streams: Array.from({ length: 30 }, (_, k) => ({ points: stroke(k), fade: true })) };
    const out = new ByteWriter();
    writeValue(out, hair);
    const packed = deflateSync(out.done(), { level: 9, mem: 12 });
    expect(toBase64Url(packed).length).toBeLessThan(1900);
  });
});

describe('a link is refused', () => {
  test('when cut anywhere, saying how much of it is left', () => {
    for (let length = link.indexOf('=') + 2; length < link.length; length++) {
      const error = refusal(link.slice(0, length));
      expect(error.code).toBe('link-cut');
      if (length > link.indexOf('=') + 16)
        expect(error.message).toContain(`at ${length} of ${link.length} characters`);
    }
  });

  test('when any one character is another', () => {
    for (let at = 0; at < payload.length; at++) {
      const other = payload[at] === 'A' ? 'B' : 'A';
      const error = refusal(`#r=${payload.slice(0, at)}${other}${payload.slice(at + 1)}`);
      expect(error.code).toBe('link-damaged');
    }
  });

  test('when it holds characters that no link has, or more than its own', () => {
    expect(refusal(`#r=${payload.slice(0, 40)}!!${payload.slice(42)}`).code).toBe('link-damaged');
    expect(refusal(`${link}AAAA`).code).toBe('link-damaged');
  });

  test('whatever it holds, with an error for people', () => {
    const codes = [
      'link-empty',
      'link-cut',
      'link-damaged',
      'link-too-new',
      'link-too-large',
      'recipe-invalid',
    ];
    fc.assert(
      fc.property(fc.uint8Array({ maxLength: 200 }), (bytes) => {
        expect(codes).toContain(refusal(`#r=${toBase64Url(bytes)}`).code);
      }),
    );
    fc.assert(
      fc.property(fc.uint8Array({ maxLength: 200 }), (plain) => {
        // Well packed, so that the reader of values itself meets the noise.
        expect([...codes, 'recipe-too-new']).toContain(refusal(sealed(plain)).code);
      }),
    );
  });

  test('when made by a newer version, even if that one packs differently', () => {
    const error = refusal(sealed(Uint8Array.of(1, 2, 3), { version: 2 }));
    expect(error.code).toBe('link-too-new');
    const unknownWord = new ByteWriter();
    unknownWord.raw(Uint8Array.of(3));
    unknownWord.varint(2 * 5000);
    expect(refusal(sealed(unknownWord.done())).code).toBe('link-too-new');
  });

  test('when it would unpack beyond the limit, said or not', () => {
    const zeros = new Uint8Array(5_000_000);
    expect(refusal(sealed(zeros)).code).toBe('link-too-large');
    expect(refusal(sealed(zeros, { declared: 1000 })).code).toBe('link-too-large');
    expect(refusal(sealed(new Uint8Array(10), { declared: 1000 })).code).toBe('link-damaged');
    expect(refusal(`#r=${'A'.repeat(2_000_000)}`).code).toBe('link-too-large');
  });

  test('when it nests beyond any recipe', () => {
    const nested = new Uint8Array(100_000).fill(5).map((kind, at) => (at % 2 ? 1 : kind));
    expect(refusal(sealed(nested)).code).toBe('link-damaged');
  });

  test('when nothing follows the mark, or there is none', () => {
    for (const address of ['', '#', '#r=', 'https://example.org/', 'https://example.org/#r=', '#r=...'])
      expect(refusal(address).code).toBe('link-empty');
    expect(hasLink('https://example.org/?r=1')).toBe(false);
    expect(hasLink(link)).toBe(true);
  });
});

test('a mesh from a file cannot travel in a link: the error names it and the project file', () => {
  const withFile = { ...recipe, models: { bar: { file: 'my mesh.ply' } } };
  expect(() => encodeLink(withFile)).toThrow(expect.objectContaining({ code: 'link-needs-file' }));
  expect(() => encodeLink(withFile)).toThrow(/"my mesh.ply".*project file/);
  const out = new ByteWriter();
  writeValue(out, withFile);
  expect(refusal(sealed(out.done())).code).toBe('link-needs-file');
});

test('a recipe too long for a link is refused when the link is made', () => {
  const long = {
    ...recipe,
    steps: [
      { ...recipe.steps[0]!, roi: Array.from({ length: 600_000 }, (_, i) => (i * i * 7919) % 1_000_003) },
    ],
  };
  expect(() => encodeLink(long)).toThrow(expect.objectContaining({ code: 'link-too-large' }));
});

/** A link whose head and checksum are right around any content. */
function sealed(plain: Uint8Array, { version = 1, declared = plain.length } = {}): string {
  const body = new ByteWriter();
  body.varint(declared);
  body.raw(deflateSync(plain, { level: 9 }));
  const packed = body.done();
  const out = new ByteWriter();
  out.byte(version);
  out.byte(
    crc32(Uint8Array.of(version, packed.length & 255, (packed.length >>> 8) & 255, packed.length >>> 16)) &
      255,
  );
  out.varint(packed.length);
  const sum = crc32(packed);
  for (const shift of [0, 8, 16, 24]) out.byte((sum >>> shift) & 255);
  out.raw(packed);
  expect(fromBase64Url(toBase64Url(out.done()))).toEqual(out.done());
  return `#r=${toBase64Url(out.done())}`;
}
