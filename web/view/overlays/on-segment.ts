/** A place on the screen, CSS pixels. */
interface Seen {
  readonly x: number;
  readonly y: number;
}

/** The place of a straight piece that is nearest to (x, y): its share of the way, and how far away it is. */
export function nearestOnSegment(
  a: Seen,
  b: Seen,
  x: number,
  y: number,
): { readonly t: number; readonly distance: number } {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const t = Math.min(1, Math.max(0, ((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy || 1)));
  return { t, distance: Math.hypot(a.x + t * dx - x, a.y + t * dy - y) };
}
