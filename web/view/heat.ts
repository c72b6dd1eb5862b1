// A diverging colour map for values that have a middle: blue, pale, red. Built in Oklab, so that equal
// steps of the value look like equal steps of colour (B. Ottosson, "A perceptual color space for image
// processing", 2020).

type Rgb = [number, number, number];

const PALE: Rgb = [0.93, 0, 0.006];
/** Lightness, chroma, hue in degrees. Both ends are equally dark, so neither looks like the more. */
const COLD = lch(0.54, 0.155, 260);
const WARM = lch(0.54, 0.155, 29);

/**
 * The map at t in [0, 1], clamped: 0 the lower end, 0.5 pale, 1 the upper end.
 *
 * @returns linear sRGB, 0–1
 */
export function heatColour(t: number): Rgb {
  const side = Math.min(1, Math.max(0, t)) * 2 - 1;
  const end = side < 0 ? COLD : WARM;
  const s = Math.abs(side);
  return oklabToLinear(PALE.map((pale, i) => pale + (end[i]! - pale) * s) as Rgb);
}

/** `stops` CSS colours evenly along the map, lowest first, for a legend's gradient. */
export function heatGradient(stops = 11): string[] {
  return Array.from({ length: stops }, (_, i) => {
    const [r, g, b] = heatColour(stops > 1 ? i / (stops - 1) : 0.5).map((c) => Math.round(255 * encode(c)));
    return `rgb(${r} ${g} ${b})`;
  });
}

/** `size` RGBA texels along the map, sRGB encoded. */
export function heatTexels(size: number): Uint8Array {
  const texels = new Uint8Array(4 * size);
  for (let i = 0; i < size; i++) {
    const colour = heatColour(i / (size - 1));
    for (let k = 0; k < 3; k++) texels[4 * i + k] = Math.round(255 * encode(colour[k]!));
    texels[4 * i + 3] = 255;
  }
  return texels;
}

function lch(lightness: number, chroma: number, hue: number): Rgb {
  const h = (hue * Math.PI) / 180;
  return [lightness, chroma * Math.cos(h), chroma * Math.sin(h)];
}

function oklabToLinear([L, a, b]: Rgb): Rgb {
  const l = (L + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (L - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (L - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    clamp(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
    clamp(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
    clamp(-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s),
  ];
}

const clamp = (c: number): number => Math.min(1, Math.max(0, c));

/** Linear light to sRGB (IEC 61966-2-1). */
export const encode = (c: number): number => (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055);
