/** Engines make an asset of every group, so that so many are sensible and clumps by the hundred are not. */
const MOST_GROUPS = 16;

/** Groups as engines mean them: the strands' own while they are few, otherwise one for all. */
export function engineGroups(groups: Uint32Array): Uint32Array {
  return new Set(groups).size <= MOST_GROUPS ? groups : new Uint32Array(groups.length);
}
