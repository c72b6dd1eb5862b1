// Matcaps: a lit sphere looked up by the normal in view space. Computed, so there is nothing to download.

import { DataTexture, LinearFilter, SRGBColorSpace, Vector3 } from 'three';
import { encode } from './heat';

interface Lamp {
  readonly from: readonly [number, number, number];
  readonly colour: readonly [number, number, number];
  /** 0 a point, 1 wraps around the whole sphere. */
  readonly wrap: number;
}

interface Recipe {
  readonly base: readonly [number, number, number];
  readonly ambientUp: number;
  readonly ambientDown: number;
  readonly lamps: readonly Lamp[];
  readonly shine: number;
  readonly sharpness: number;
  readonly rim: readonly [number, number, number];
}

export type MatcapName = 'matcap-clay' | 'matcap-pearl' | 'matcap-jade' | 'matcap-graphite';

const KEY: Lamp = { from: [-0.5, 0.75, 0.65], colour: [0.95, 0.92, 0.88], wrap: 0.35 };
const FILL: Lamp = { from: [0.85, 0.1, 0.4], colour: [0.2, 0.23, 0.28], wrap: 0.6 };

const RECIPES: Readonly<Record<MatcapName, Recipe>> = {
  'matcap-clay': {
    base: [0.56, 0.3, 0.2],
    ambientUp: 0.34,
    ambientDown: 0.12,
    lamps: [KEY, FILL],
    shine: 0.1,
    sharpness: 14,
    rim: [0.1, 0.06, 0.05],
  },
  'matcap-pearl': {
    base: [0.74, 0.73, 0.74],
    ambientUp: 0.36,
    ambientDown: 0.16,
    lamps: [KEY, { ...FILL, colour: [0.24, 0.22, 0.3] }],
    shine: 0.22,
    sharpness: 40,
    rim: [0.1, 0.12, 0.2],
  },
  'matcap-jade': {
    base: [0.16, 0.44, 0.3],
    ambientUp: 0.42,
    ambientDown: 0.2,
    lamps: [
      { ...KEY, wrap: 0.55 },
      { ...FILL, colour: [0.16, 0.3, 0.2] },
    ],
    shine: 0.4,
    sharpness: 60,
    rim: [0.08, 0.2, 0.1],
  },
  'matcap-graphite': {
    base: [0.095, 0.1, 0.11],
    ambientUp: 0.5,
    ambientDown: 0.15,
    lamps: [KEY, FILL, { from: [0.3, -0.8, 0.4], colour: [0.16, 0.14, 0.12], wrap: 0.4 }],
    shine: 0.32,
    sharpness: 22,
    rim: [0.12, 0.14, 0.17],
  },
};

export function matcapTexture(name: MatcapName, size = 256): DataTexture {
  const texture = new DataTexture(matcapTexels(name, size), size, size);
  texture.colorSpace = SRGBColorSpace;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

function matcapTexels(name: MatcapName, size: number): Uint8Array {
  const recipe = RECIPES[name];
  const lamps = recipe.lamps.map((lamp) => {
    const from = new Vector3(...lamp.from).normalize();
    return {
      ...lamp,
      from,
      half: from
        .clone()
        .add(new Vector3(0, 0, 1))
        .normalize(),
    };
  });
  const texels = new Uint8Array(4 * size * size);
  const normal = new Vector3();
  for (let j = 0; j < size; j++) {
    for (let i = 0; i < size; i++) {
      normal.set((2 * (i + 0.5)) / size - 1, (2 * (j + 0.5)) / size - 1, 0);
      const flat = Math.min(0.998, normal.x ** 2 + normal.y ** 2);
      normal.setLength(Math.sqrt(flat)).setZ(Math.sqrt(1 - flat));
      const ambient = recipe.ambientDown + (recipe.ambientUp - recipe.ambientDown) * (normal.y * 0.5 + 0.5);
      const rim = (1 - normal.z) ** 3;
      for (let k = 0; k < 3; k++) {
        let light = ambient;
        let gloss = recipe.rim[k]! * rim * (0.6 + 0.4 * normal.y);
        for (const lamp of lamps) {
          const facing = Math.max(0, (normal.dot(lamp.from) + lamp.wrap) / (1 + lamp.wrap));
          light += lamp.colour[k]! * facing ** (1 + lamp.wrap);
          gloss +=
            lamp.colour[k]! * recipe.shine * Math.max(0, normal.dot(lamp.half)) ** (4 * recipe.sharpness);
          gloss +=
            lamp.colour[k]! *
            recipe.shine *
            0.3 *
            Math.max(0, normal.dot(lamp.half)) ** (0.5 * recipe.sharpness);
        }
        const lit = recipe.base[k]! * light + Math.max(0, gloss);
        // A soft shoulder, so that highlights roll off as film does.
        texels[4 * (j * size + i) + k] = Math.round(
          255 * encode(Math.min(1, lit < 0.6 ? lit : 1 - 0.4 * Math.exp((0.6 - lit) / 0.4))),
        );
      }
      texels[4 * (j * size + i) + 3] = 255;
    }
  }
  return texels;
}
