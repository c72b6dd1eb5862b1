/** A number of bytes as people say it. */
export function inBytes(count: number): string {
  for (const [unit, size] of [
    ['GB', 1e9],
    ['MB', 1e6],
    ['kB', 1e3],
  ] as const)
    if (count >= 10 * size) return `${Math.round(count / size)} ${unit}`;
  return `${Math.round(count)} bytes`;
}
