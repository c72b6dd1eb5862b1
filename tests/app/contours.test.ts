import { expect, test } from 'vitest';
import { withFine } from '../../web/app/curves/contours/view-lines';
import type { ContourLines } from '../../web/kernel/contract/contour';

/** Lines of so many points each; the number of a line is where its points are. */
function linesOf(counts: readonly (readonly [points: number, suggestive: 0 | 1])[], from = 0): ContourLines {
  const numbered = counts.flatMap(([count], i) => new Array<number>(3 * count).fill(from + i));
  const offsets = [0];
  for (const [count] of counts) offsets.push(offsets.at(-1)! + count);
  return {
    points: Float64Array.from(numbered),
    corners: Uint32Array.from(numbered),
    weights: Float32Array.from(numbered),
    offsets: Uint32Array.from(offsets),
    suggestive: Uint8Array.from(counts, ([, flag]) => flag),
    closed: Uint8Array.from(counts, () => 0),
    strength: Float64Array.from(counts, (_, i) => from + i),
    seconds: 0,
  };
}

test('contours of a newer view and the suggestive lines of an older one make one drawing', () => {
  const newer = linesOf([
    [2, 0],
    [3, 0],
    [4, 0],
  ]);
  const older = linesOf(
    [
      [5, 0],
      [2, 1],
      [3, 1],
    ],
    10,
  );
  const { points, offsets, suggestive, strength } = withFine(newer, older);
  expect([...suggestive]).toEqual([0, 0, 0, 1, 1]);
  expect([...offsets]).toEqual([0, 2, 5, 9, 11, 14]);
  expect([...strength]).toEqual([0, 1, 2, 11, 12]);
  expect(points[3 * 9]).toBe(11);
  expect(points.length).toBe(3 * 14);
  expect(withFine(newer, linesOf([[5, 0]]))).toBe(newer);
});
