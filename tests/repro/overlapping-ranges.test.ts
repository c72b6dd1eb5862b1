// A link of 233 characters named twenty thousand times the same thirty thousand vertices: six hundred million indices
// were written down before they were merged.

import { expect, test } from 'vitest';
import { sizeOf, toIndices, type VertexSet } from '../../web/core/vertex-set';
import { decodeLink } from '../../web/recipe/link/link';
import { checkApart, checkVertices } from '../../web/run/vertex-sets';
import { spent } from './bounded';
import { equalRanges } from './hostile';

const COUNT = 29_782;
const SAME: VertexSet = { ranges: Array.from({ length: 20_000 }, () => [0, COUNT - 1] as const) };

test('ranges are merged before they are expanded', () => {
  const { value, made } = spent('20,000 equal ranges', () => toIndices(SAME, COUNT));
  expect(value).toEqual(Uint32Array.from({ length: COUNT }, (_, i) => i));
  expect(made).toBe(COUNT);
  expect(sizeOf(SAME, COUNT)).toBe(COUNT);
});

test('what lies beyond the model is never written down', () => {
  const far: VertexSet = { ranges: [[0, Number.MAX_SAFE_INTEGER]] };
  expect(spent('a range to the end of numbers', () => toIndices(far, 10)).made).toBe(10);
  expect([...toIndices([3, 2 ** 32, 1, 3, Number.MAX_SAFE_INTEGER], 10)]).toEqual([1, 3]);
  expect(() => checkVertices(far, 'steps[0].roi', { name: 'm', vertices: 10 })).toThrow(
    /^steps\[0\]\.roi: vertex 9007199254740991 is out of range; "m" has 10 vertices, numbered 0 to 9\.$/,
  );
});

test('handles over all of a model, a thousand of them, are counted before they are expanded', () => {
  const sets = Array.from({ length: 1000 }, () => SAME);
  expect(() => checkApart(sets.slice(0, 3), 'steps[0].handles', { name: 'm', vertices: COUNT })).toThrow(
    /^steps\[0\]\.handles: the handles name 89346 vertices together, but "m" has 29782; give each vertex/,
  );
  expect(() => checkApart([SAME, []], 'steps[0].handles', { name: 'm', vertices: COUNT })).not.toThrow();
});

test('the link itself opens', () => {
  const link = equalRanges();
  expect(link.length).toBeLessThan(400);
  const [step] = decodeLink(link).steps;
  expect(step?.type === 'deform' && sizeOf(step.handles[0]!.vertices, COUNT)).toBe(COUNT);
});
