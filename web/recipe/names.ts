/** `base` with the first number, from 1, that none of those taken has. */
export function freeName(base: string, taken: readonly string[]): string {
  const known = new Set(taken);
  for (let number = 1; ; number++) if (!known.has(`${base} ${number}`)) return `${base} ${number}`;
}
