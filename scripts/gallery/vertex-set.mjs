/** Ascending vertices in the recipe's shortest form. */
export function setOf(vertices) {
  const ranges = [];
  for (const v of vertices) {
    if (ranges.at(-1)?.[1] === v - 1) ranges.at(-1)[1] = v;
    else ranges.push([v, v]);
  }
  return ranges.length * 2 < vertices.length ? { ranges } : vertices;
}
