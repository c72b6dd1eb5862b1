// The short run: the same rounds every time. The long one is `npm run fuzz`; what it finds becomes a file in tests/repro.

import { expect, test } from 'vitest';
import { Fuzzing, generators } from './fuzz';
import { Random } from './random';

const ROUNDS = 360;

test('a seed brings back the same input', () => {
  const numbers = (seed: number, stream: string) => {
    const random = new Random(seed, stream);
    return random.list(5, () => random.share());
  };
  expect(numbers(7, 'a')).toEqual(numbers(7, 'a'));
  expect(numbers(7, 'a')).not.toEqual(numbers(8, 'a'));
  expect(numbers(7, 'a')).not.toEqual(numbers(7, 'b'));
});

test('a finding is told with its kind and seed, and the round goes on', async () => {
  const fuzzing = new Fuzzing([
    {
      kind: 'wrong',
      run: (random) => {
        if (random.chance(0.5)) throw new TypeError('raw');
        return 'accepted';
      },
    },
    { kind: 'right', run: () => 'refused' },
  ]);
  for (let seed = 1; seed <= 20; seed++) await fuzzing.round(seed);
  expect(fuzzing.inputs).toBe(40);
  expect(fuzzing.findings.length).toBeGreaterThan(3);
  const [{ kind, seed } = { kind: '', seed: 0 }] = fuzzing.findings;
  expect(kind).toBe('wrong');
  const again = new Fuzzing([
    { kind, run: (random) => (random.chance(0.5) ? Promise.reject(new Error('raw')) : 'accepted') },
  ]);
  await again.round(seed);
  expect(again.findings).toHaveLength(1);
});

test(`${ROUNDS} rounds of damaged files, links, recipes and runs end in a sentence or in something whole`, async () => {
  const fuzzing = new Fuzzing(generators);
  for (let seed = 1; seed <= ROUNDS; seed++) await fuzzing.round(seed);
  console.log(`${fuzzing.table()}\n${fuzzing.inputs} inputs, ${fuzzing.kernelCalls} kernel calls`);
  expect(fuzzing.findings.map(({ kind, seed, error }) => `${kind}, seed ${seed}: ${error}`)).toEqual([]);
  // Each kind gets somewhere: a reader that refuses everything is not tried.
  for (const [kind, { accepted, inputs }] of fuzzing.counts)
    if (inputs >= 20) expect(accepted, kind).toBeGreaterThan(0);
}, 180_000);
