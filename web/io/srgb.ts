// Colours are sRGB bytes in a model and in most formats, and linear in glTF (IEC 61966-2-1).

/** 0–255, not rounded, of a linear value in [0, 1]. */
export function toSrgb(linear: number): number {
  return 255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055);
}

/** Linear value in [0, 1] of an sRGB byte. */
export function fromSrgb(byte: number): number {
  const c = byte / 255;
  return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
}
