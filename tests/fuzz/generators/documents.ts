// Recipes and links: valid ones of every step type, changed in a few places.

import { deflateSync } from 'fflate';
import { toBase64Url } from '../../../web/core/base64url';
import { crc32 } from '../../../web/core/crc32';
import { hashValue } from '../../../web/core/hash';
import { firstOutside, fromIndices, toIndices, type VertexSet } from '../../../web/core/vertex-set';
import { formatRecipe } from '../../../web/recipe/format';
import { ByteWriter } from '../../../web/recipe/link/bytes';
import { decodeLink, encodeLink } from '../../../web/recipe/link/link';
import { writeValue } from '../../../web/recipe/link/value';
import { parseRecipe } from '../../../web/recipe/parse';
import { type Generator, must, outcomeOf } from '../generator';
import { bytesOf, mutateBytes, mutateJson, mutateText, textOf, tweakJson } from '../mutate';
import type { Random } from '../random';
import { EXAMPLES } from '../recipes';

const TEXTS = EXAMPLES.map((recipe) => formatRecipe(parseRecipe(recipe)));
const LINKS = EXAMPLES.map((recipe) => encodeLink(parseRecipe(recipe)));

/** A link whose head and checksum are right around any content, so that the reader of values itself meets it. */
function sealed(plain: Uint8Array, declared = plain.length): string {
  const body = new ByteWriter();
  body.varint(declared);
  body.raw(deflateSync(plain));
  const packed = body.done();
  const { length } = packed;
  const out = new ByteWriter();
  out.byte(1);
  out.byte(crc32(Uint8Array.of(1, length & 255, (length >>> 8) & 255, (length >>> 16) & 255)) & 255);
  out.varint(length);
  for (const shift of [0, 8, 16, 24]) out.byte((crc32(packed) >>> shift) & 255);
  out.raw(packed);
  return `#r=${toBase64Url(out.done())}`;
}

function linkOf(random: Random): string {
  if (random.chance(0.2)) return textOf(mutateBytes(random, bytesOf(random.pick(LINKS))));
  const plain = new ByteWriter();
  writeValue(plain, jsonOnly(changedRecipe(random)));
  return sealed(mutateBytes(random, plain.done(), random.below(4)));
}

const changedRecipe = (random: Random): unknown => {
  const recipe = random.pick(EXAMPLES);
  return random.chance(0.5) ? tweakJson(random, recipe) : mutateJson(random, recipe, random.few(3));
};

/** As a link can hold it: no number beyond the finite ones. */
const jsonOnly = (value: unknown): unknown => JSON.parse(JSON.stringify(value) ?? 'null');

/** What must hold of any recipe that is taken. */
function check(recipe: ReturnType<typeof parseRecipe>): void {
  const text = formatRecipe(recipe);
  must(formatRecipe(parseRecipe(text)) === text, 'a recipe that reads back as another');
  must(hashValue(recipe) === hashValue(parseRecipe(recipe)), 'a recipe that hashes as another');
}

const RANGES = (random: Random): VertexSet => {
  const end = () => random.below(random.chance(0.99) ? 100 : random.pick([2 ** 32, Number.MAX_SAFE_INTEGER]));
  if (random.chance(0.3)) return random.list(random.few(200), end);
  return {
    ranges: random.list(random.few(200), () => [end(), end()].sort((a, b) => a - b) as [number, number]),
  };
};

const documents: readonly Generator[] = [
  {
    kind: 'link',
    run: (random) =>
      outcomeOf(async () => {
        const recipe = decodeLink(linkOf(random));
        check(recipe);
        await outcomeOf(() =>
          must(hashValue(decodeLink(encodeLink(recipe))) === hashValue(recipe), 'another link'),
        );
      }),
  },
  {
    kind: 'recipe',
    run(random) {
      const changed = changedRecipe(random);
      return outcomeOf(() =>
        check(parseRecipe(random.chance(0.5) ? changed : (JSON.stringify(changed) ?? ''))),
      );
    },
  },
  {
    kind: 'recipe text',
    run(random) {
      const text = random.pick(TEXTS);
      const changed = random.chance(0.5)
        ? mutateText(random, text)
        : textOf(mutateBytes(random, bytesOf(text)));
      return outcomeOf(() => check(parseRecipe(changed)));
    },
  },
  {
    kind: 'vertex set',
    run(random) {
      const set = RANGES(random);
      const count = random.below(300);
      const indices = toIndices(set, count);
      must(
        indices.length <= count && indices.every((v, i) => v < count && (i === 0 || v > indices[i - 1]!)),
        'order',
      );
      if (firstOutside(set, count) !== undefined) return 'outside';
      must(
        String(toIndices(fromIndices(indices, count), count)) === String(indices),
        'a set that comes back as another',
      );
      return 'accepted';
    },
  },
];
export default documents;
