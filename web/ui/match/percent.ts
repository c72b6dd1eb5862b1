/** A share of a model's size with as many digits as tell. */
export function percent(share: number): string {
  const value = 100 * share;
  if (value === 0) return '0 %';
  const digits = value >= 10 ? 0 : value >= 1 ? 1 : value >= 0.1 ? 2 : 3;
  return value < 0.0005 ? '< 0.001 %' : `${Number(value.toFixed(digits))} %`;
}
