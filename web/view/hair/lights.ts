import { Color, Vector3 } from 'three';
import { ENVIRONMENT, KEY, KEY_COLOUR, KEY_INTENSITY, SOFT_BOXES, type SoftBox, WALLS } from '../studio';

/** A lamp as strands see it: far away, of a certain angle. */
export interface SoftLight {
  /** Unit vector to the lamp. */
  readonly towards: Vector3;
  /** Irradiance on a surface that faces it, linear. */
  readonly light: Color;
  /** Half the angle it is seen under. */
  readonly spread: number;
}

function softLight({ at, size, light, colour }: SoftBox): SoftLight {
  const distance = Math.hypot(...at);
  const angle = (size[0] * size[1]) / distance ** 2;
  return {
    towards: new Vector3(...at).normalize(),
    light: new Color(colour).multiplyScalar(light * angle * ENVIRONMENT),
    spread: Math.sqrt(angle) / 2,
  };
}

const boxes = SOFT_BOXES.map(softLight);

/** The studio's lamps that matter to hair: from above, from the front and from behind. */
export const SOFT_LIGHTS: readonly [SoftLight, SoftLight, SoftLight] = [boxes[0]!, boxes[1]!, boxes[3]!];
/** The lamp at the other side of the key: where it shines it comes unhindered. */
export const FILL_LIGHT = boxes[2]!;
export const KEY_LIGHT = {
  towards: KEY.clone().normalize(),
  light: new Color(KEY_COLOUR).multiplyScalar(KEY_INTENSITY),
};
/** Radiance from above and below: the walls, and the lamps that are left. */
export const SKY = new Color(...WALLS.ceiling).multiplyScalar(ENVIRONMENT).addScalar(0.16);
export const GROUND = new Color(...WALLS.floor).multiplyScalar(ENVIRONMENT).addScalar(0.08);
