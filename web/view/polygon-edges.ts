/**
 * The file's own edges, each once: a quad has four, whatever diagonal the triangulation chose.
 *
 * @returns 2 source vertices per edge
 */
export function polygonEdges(
  faceOffsets: Uint32Array,
  faceVertices: Uint32Array,
  vertexCount: number,
): Uint32Array {
  // Half edges sorted by their lower end (counting sort); repeats then lie in one short bucket.
  const offsets = new Uint32Array(vertexCount + 2);
  const eachEdge = (visit: (low: number, high: number) => void): void => {
    for (let f = 0; f + 1 < faceOffsets.length; f++) {
      const start = faceOffsets[f]!;
      const end = faceOffsets[f + 1]!;
      for (let i = start; i < end; i++) {
        const a = faceVertices[i]!;
        const b = faceVertices[i + 1 < end ? i + 1 : start]!;
        if (a !== b && a < vertexCount && b < vertexCount) visit(Math.min(a, b), Math.max(a, b));
      }
    }
  };
  eachEdge((low) => offsets[low + 2]!++);
  for (let v = 2; v < offsets.length; v++) offsets[v]! += offsets[v - 1]!;
  const highs = new Uint32Array(offsets.at(-1)!);
  eachEdge((low, high) => {
    highs[offsets[low + 1]!++] = high;
  });
  const edges = new Uint32Array(2 * highs.length);
  let count = 0;
  for (let low = 0; low < vertexCount; low++) {
    const first = offsets[low]!;
    const last = offsets[low + 1]!;
    for (let i = first; i < last; i++) {
      const high = highs[i]!;
      const before = highs.indexOf(high, first);
      if (before < i) continue;
      edges[count++] = low;
      edges[count++] = high;
    }
  }
  return edges.slice(0, count);
}
