import { boxOf, coordinatesOf, middleOf, sizeOf } from '../../core/box';
import type { Model } from '../../core/model';
import type { Strands } from '../../core/strands';
import { likelyUnit } from './groom-file';

// Strands of a file on a head that is already open: the way back from space.ts.

/** The roots' middle may lie so many scalps away from the scalp's, and the roots be spread so many scalps wide. */
const FARTHEST = 0.75;
const NARROWEST = 0.1;
const WIDEST = 3;

/**
 * The strands in the head's own space, taken as they are or as centimetres with Y up, whichever suits
 * the scalp better.
 *
 * @param scalp  vertices of the head
 * @returns `null` where neither brings them to it
 */
export function placedOn(head: Model, scalp: Uint32Array, strands: Strands): Strands | null {
  const skin = spreadOf(coordinatesOf(head.positions, scalp));
  const size = Math.max(...skin.size);
  if (!(size > 0)) return null;
  const scale = 1 / (head.unitMetres ? 100 * head.unitMetres : likelyUnit(size));
  const zUp = head.upAxis === 'z';
  const ways = scale === 1 && !zUp ? [strands] : [strands, fromFileSpace(strands, scale, zUp)];
  const measured = ways.map((way) => {
    const roots = spreadOf(rootsOf(way));
    const off = Math.hypot(...roots.centre.map((x, k) => x - skin.centre[k]!)) / size;
    const spread = Math.max(...roots.size) / size;
    return { way, fits: off <= FARTHEST && spread >= NARROWEST && spread <= WIDEST, off, spread };
  });
  const misfit = ({ off, spread }: (typeof measured)[number]): number => off + Math.abs(Math.log(spread));
  const [best] = measured.filter(({ fits }) => fits).toSorted((a, b) => misfit(a) - misfit(b));
  return best?.way ?? null;
}

function fromFileSpace(strands: Strands, scale: number, zUp: boolean): Strands {
  const place = (x: number, y: number, z: number): [number, number, number] =>
    zUp ? [scale * x, -scale * z, scale * y] : [scale * x, scale * y, scale * z];
  const points = new Float32Array(strands.points.length);
  for (let p = 0; p < points.length; p += 3)
    points.set(place(strands.points[p]!, strands.points[p + 1]!, strands.points[p + 2]!), p);
  const look = { ...strands.look, thickness: scale * strands.look.thickness };
  return { ...strands, points, origin: place(...strands.origin), look };
}

function* rootsOf({ offsets, points, origin }: Strands): Iterable<number> {
  for (const p of offsets.subarray(0, -1)) for (let k = 0; k < 3; k++) yield points[3 * p + k]! + origin[k]!;
}

function spreadOf(coordinates: Iterable<number>) {
  const box = boxOf(coordinates);
  return { centre: middleOf(box), size: sizeOf(box).map((x) => Math.max(0, x)) };
}
