import fc from 'fast-check';
import { expect, test } from 'vitest';
import { chooseGuides, closestGuides } from '../../../web/io';
import { makeGroom } from './support';

const { strands } = makeGroom(300, () => 4);
const root = (s: number) => [0, 1, 2].map((k) => strands.points[12 * s + k]!);
const apart = (a: number, b: number) => Math.hypot(...root(a).map((c, k) => c - root(b)[k]!));

test('guides are the first strand and those farthest from all before them', () => {
  expect([...chooseGuides(strands, 1)]).toEqual([0]);
  for (let count = 1; count < 12; count++) {
    const before = [...chooseGuides(strands, count)];
    const after = [...chooseGuides(strands, count + 1)];
    const [added] = after.filter((s) => !before.includes(s));
    expect(after.length).toBe(count + 1);
    const reach = (s: number) => Math.min(...before.map((g) => apart(s, g)));
    for (let s = 0; s < 300; s++) expect(reach(s)).toBeLessThanOrEqual(reach(added!) + 1e-4);
  }
});

test('there are never more guides than strands, and none without a root', () => {
  expect([...chooseGuides(strands, 1000)]).toEqual(Array.from({ length: 300 }, (_, s) => s));
  const { strands: some } = makeGroom(6, (s) => s % 2);
  expect([...chooseGuides(some, 6)]).toEqual([1, 3, 5]);
  expect([...chooseGuides(makeGroom(0, () => 0).strands, 3)]).toEqual([]);
});

test('the three closest guides are those that a search through all finds', () => {
  const numbers = fc.uniqueArray(fc.nat(299), { minLength: 1, maxLength: 120 });
  fc.assert(
    fc.property(numbers, (chosen) => {
      const guides = Uint32Array.from(chosen).sort();
      const { places } = closestGuides(strands, guides);
      for (let s = 0; s < 300; s += 7) {
        const sorted = [...guides].map((g) => apart(s, g)).sort((a, b) => a - b);
        const found = [...places.subarray(3 * s, 3 * s + 3)]
          .slice(0, guides.length)
          .map((p) => apart(s, guides[p]!));
        if (found[0]! > 0) expect(found).toEqual(sorted.slice(0, found.length));
        else expect(sorted[0]).toBe(0);
      }
    }),
    { numRuns: 60 },
  );
});

test('weights sum to one, fall with the distance, and a guide follows itself alone', () => {
  const guides = chooseGuides(strands, 20);
  const { places, weights } = closestGuides(strands, guides);
  for (let s = 0; s < 300; s++) {
    const [a, b, c] = weights.subarray(3 * s, 3 * s + 3) as unknown as [number, number, number];
    expect(a + b + c).toBeCloseTo(1, 5);
    expect(a).toBeGreaterThanOrEqual(b);
    expect(b).toBeGreaterThanOrEqual(c);
  }
  guides.forEach((s, place) => {
    expect([...places.subarray(3 * s, 3 * s + 3)]).toEqual([place, place, place]);
    expect([...weights.subarray(3 * s, 3 * s + 3)]).toEqual([1, 0, 0]);
  });
});

test('guides of the strand’s own group come before nearer ones of others', () => {
  const guides = chooseGuides(strands, 30);
  const groups = strands.groups!.map((g) => (g === 2 ? 7 : g));
  const { places } = closestGuides(strands, guides, groups);
  const withGuides = new Set([...guides].map((g) => groups[g]!));
  for (let s = 0; s < 300; s++)
    if (withGuides.has(groups[s]!)) expect(groups[guides[places[3 * s]!]!]).toBe(groups[s]);
});
