// A model opened while a smaller one was on screen had its handles tinted up to the smaller one's last vertex only: a set
// was unpacked for the first count of vertices it was asked with, and kept.

import { expect, test } from 'vitest';
import { listed } from '../../web/app/painted-regions';

test('a set unpacked for a small model is whole on a large one', () => {
  const set = { ranges: [[5, 14]] as [number, number][] };
  expect([...listed(set, 8)]).toEqual([5, 6, 7]);
  expect([...listed(set, 100)]).toHaveLength(10);
  // Asked again it is the same list, so that nothing is drawn anew.
  expect(listed(set, 100)).toBe(listed(set, 100));
});
