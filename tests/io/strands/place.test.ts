import { expect, test } from 'vitest';
import type { Model } from '../../../web/core/model';
import type { Groom, Strands } from '../../../web/core/strands';
import { readStrands, writeStrands } from '../../../web/io/strands/formats';
import { hasObjLines } from '../../../web/io/strands/obj-lines';
import { placedOn } from '../../../web/io/strands/place';
import { HEAD, makeGroom } from './support';

/** The box again in another unit, lying on its back where z is up, somewhere else. */
function headIn(unitMetres: number, upAxis: 'y' | 'z', [dx, dy, dz] = [0, 0, 0]): Model {
  const scale = 0.001 / unitMetres;
  const positions = HEAD.positions.slice();
  for (let v = 0; v < positions.length; v += 3) {
    const [x, y, z] = [0, 1, 2].map((k) => scale * HEAD.positions[v + k]!) as [number, number, number];
    const turned = upAxis === 'z' ? [x, -z, y] : [x, y, z];
    positions.set([turned[0]! + dx!, turned[1]! + dy!, turned[2]! + dz!], v);
  }
  return { ...HEAD, positions, unitMetres, upAxis };
}

/** The corners that are up. */
const SCALP = Uint32Array.of(2, 3, 6, 7);

function onHead(head: Model): Groom {
  const { strands } = makeGroom(60, () => 9);
  const scale = 0.001 / head.unitMetres!;
  const turn = ([x, y, z]: number[]) => (head.upAxis === 'z' ? [x!, -z!, y!] : [x!, y!, z!]);
  const points = strands.points.slice();
  for (let p = 0; p < points.length; p += 3)
    points.set(turn([0, 1, 2].map((k) => scale * strands.points[p + k]!)), p);
  const [x = 0, y = 0, z = 0] = [0, 1, 2].map(
    (k) => head.positions[k]! - headIn(head.unitMetres!, head.upAxis ?? 'y').positions[k]!,
  );
  const look = { ...strands.look, thickness: scale * strands.look.thickness };
  return { name: 'wavy', strands: { ...strands, points, origin: [x, y, z], look }, head };
}

const absolute = ({ points, origin }: Strands): number[] => Array.from(points, (x, i) => x + origin[i % 3]!);

test.each([
  ['millimetres, y up', 0.001, 'y', [0, 0, 0]],
  ['metres, y up, away from the origin', 1, 'y', [0.4, 1.5, 0]],
  ['decimetres, z up', 0.1, 'z', [0, 0, 0]],
  ['inches, z up, away from the origin', 0.0254, 'z', [3, -2, 60]],
] as const)('a .hair file lies on the head it was written from, which is in %s', (_, unit, up, at) => {
  const head = headIn(unit, up, [...at]);
  const groom = onHead(head);
  const bytes = writeStrands(groom, 'hair', { centimetresPerUnit: 100 * unit });
  const placed = placedOn(head, SCALP, readStrands(bytes, 'wavy.hair').strands)!;
  const size = 240 * (0.001 / unit);
  const wanted = absolute(groom.strands);
  absolute(placed).forEach((x, i) => {
    expect(Math.abs(x - wanted[i]!) / size).toBeLessThan(2e-6 * (1 + Math.hypot(...at) / size));
  });
  expect(placed.look.thickness / groom.strands.look.thickness).toBeCloseTo(1, 5);
});

test('strands in the head’s own unit are taken as they are', () => {
  const head = headIn(1, 'y');
  const { strands } = onHead(head);
  expect(placedOn(head, SCALP, strands)).toBe(strands);
});

test('strands of something else lie on no head', () => {
  const head = headIn(1, 'y');
  const { strands } = onHead(head);
  expect(placedOn(head, SCALP, { ...strands, origin: [0, 5, 0] })).toBeNull();
  const wide = strands.points.map((x) => 10 * x);
  expect(placedOn(head, SCALP, { ...strands, points: wide })).toBeNull();
  expect(placedOn(head, new Uint32Array(), strands)).toBeNull();
});

test('an OBJ has lines where a line begins with the letter, and only there', () => {
  const has = (text: string): boolean => hasObjLines(new TextEncoder().encode(text));
  expect(has('v 0 0 0\nl 1 2')).toBe(true);
  expect(has('l 1 2')).toBe(true);
  expect(has('v 0 0 0\r\nl\t1 2\r\n')).toBe(true);
  expect(has('o tail l 1\nusemtl l\nlod 3\n# l 1 2')).toBe(false);
});
