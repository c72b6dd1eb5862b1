// How many strands are drawn. They come in an order whose every prefix covers the scalp evenly, so fewer
// strands are a shorter prefix of thicker ones.

/** Strands are never drawn thicker than this many times: beyond it they look like straw. */
export const WIDEST = 3;
/** A moving picture should not take longer, in ms. */
const TARGET = 20;
const FEWEST = 2000;
/** Drawn before anything is known about the machine's speed. */
const FIRST = 20_000;
/** A moving picture that took so many times too long gets its share at once, not step by step. */
const FAR_OFF = 8;
/** Without a graphics card a picture at rest has so many times the strands of a moving one. */
const AT_REST_IN_SOFTWARE = 2;

export interface Prefix {
  readonly count: number;
  /** Keeps the covered area, up to `WIDEST`. */
  readonly widthScale: number;
}

/** @param share  0..1 of `total`; at least one strand is drawn when there is one */
export function prefixOf(total: number, share: number): Prefix {
  if (total === 0) return { count: 0, widthScale: 1 };
  const wanted = Number.isFinite(share) ? Math.min(1, Math.max(0, share)) : 1;
  const count = Math.min(total, Math.max(1, Math.round(total * wanted)));
  return { count, widthScale: Math.min(WIDEST, total / count) };
}

/** @param software  the pictures are drawn without a graphics card */
export function firstShare(total: number, software: boolean): number {
  const first = software ? FEWEST : FIRST;
  return total <= first ? 1 : first / total;
}

/** The share for pictures at rest: all strands, unless one picture of them would keep the page from answering. */
export const restShare = (share: number, software: boolean): number =>
  software ? Math.min(1, AT_REST_IN_SOFTWARE * share) : 1;

/**
 * The share for the next moving picture.
 *
 * @param elapsed  ms the last one took, from picture to picture
 */
export function nextShare(share: number, elapsed: number, total: number): number {
  const least = total > 0 ? Math.min(1, FEWEST / total) : 1;
  if (elapsed > FAR_OFF * TARGET) return Math.max(least, (share * TARGET) / elapsed);
  if (elapsed > 1.25 * TARGET) return Math.max(least, share * Math.max(0.5, TARGET / elapsed));
  if (elapsed < 0.9 * TARGET) return Math.min(1, share * 1.12);
  return share;
}
