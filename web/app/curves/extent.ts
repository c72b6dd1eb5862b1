const known = new WeakMap<Float64Array, number>();

/** The largest extent of points along an axis; those that are not finite are left out. */
export function extentOf(positions: Float64Array): number {
  let size = known.get(positions);
  if (size !== undefined) return size;
  size = 0;
  for (let axis = 0; axis < 3; axis++) {
    let [low, high] = [Infinity, -Infinity];
    for (let i = axis; i < positions.length; i += 3) {
      const x = positions[i]!;
      if (!Number.isFinite(x)) continue;
      low = Math.min(low, x);
      high = Math.max(high, x);
    }
    size = Math.max(size, high - low);
  }
  known.set(positions, size);
  return size;
}
