// The primitives of a hair step: which there are, how they are numbered, what curves they are made of.

import type { HairStep } from '../../recipe/recipe';
import type { ControlLine } from '../../view/overlays/types';
import type { Vec3 } from '../../view/types';

export type Point = [number, number, number];
export type Stream = HairStep['streams'][number];
export type Parting = HairStep['partings'][number];
export type Ponytail = HairStep['ponytails'][number];
export type Style = Pick<HairStep, 'streams' | 'partings' | 'ponytails'>;

export type Primitive =
  | { readonly kind: 'stream'; readonly item: Stream }
  | { readonly kind: 'parting'; readonly item: Parting }
  | { readonly kind: 'ponytail'; readonly item: Ponytail };
export type PrimitiveKind = Primitive['kind'];

/** Name, hiding and options: all but the curves. */
export type PrimitivePatch = Partial<
  Pick<Stream, 'fade' | 'name' | 'hidden'> &
    Pick<Parting, 'tilt' | 'sigma' | 'height'> &
    Pick<Ponytail, 'tightness'>
>;

/** One line of a primitive. */
export type Part = 'points' | 'spine' | 'section' | 'profile-0' | 'profile-1';

/** All primitives, in the order in which a selection counts them: streams, partings, ponytails. */
export const primitivesOf = ({ streams, partings, ponytails }: Style): Primitive[] => [
  ...streams.map((item) => ({ kind: 'stream', item }) as const),
  ...partings.map((item) => ({ kind: 'parting', item }) as const),
  ...ponytails.map((item) => ({ kind: 'ponytail', item }) as const),
];

export const primitiveAt = (style: Style, index: number | null): Primitive | undefined =>
  index === null ? undefined : primitivesOf(style)[index];

/** The style with another list of primitives, sorted into its three lists in the order given. */
export function withPrimitives<S extends Style>(style: S, primitives: readonly Primitive[]): S {
  const streams: Stream[] = [];
  const partings: Parting[] = [];
  const ponytails: Ponytail[] = [];
  for (const { kind, item } of primitives) {
    if (kind === 'stream') streams.push(item);
    else if (kind === 'parting') partings.push(item);
    else ponytails.push(item);
  }
  return { ...style, streams, partings, ponytails };
}

/** @returns the style with one primitive more, and its number */
export function added<S extends Style>(style: S, primitive: Primitive): { style: S; index: number } {
  const before = primitivesOf(style);
  const order = { stream: 0, parting: 1, ponytail: 2 };
  const index = before.filter(({ kind }) => order[kind] <= order[primitive.kind]).length;
  return { style: withPrimitives(style, before.toSpliced(index, 0, primitive)), index };
}

export const replaced = <S extends Style>(style: S, index: number, primitive: Primitive): S =>
  withPrimitives(style, primitivesOf(style).with(index, primitive));

export const removed = <S extends Style>(style: S, index: number): S =>
  withPrimitives(style, primitivesOf(style).toSpliced(index, 1));

/** The lines a primitive is made of, those not drawn yet left out. */
export function partsOf({ kind, item }: Primitive): { readonly part: Part; readonly points: Point[] }[] {
  const parts: { part: Part; points: Point[] }[] =
    kind === 'ponytail'
      ? [
          { part: 'spine', points: item.spine },
          { part: 'section', points: item.section },
          { part: 'profile-0', points: item.profiles[0] ?? [] },
          { part: 'profile-1', points: item.profiles[1] ?? [] },
        ]
      : [{ part: 'points', points: item.points }];
  return parts.filter(({ points }) => points.length > 0);
}

export const pointsOf = (primitive: Primitive, part: Part): readonly Vec3[] =>
  partsOf(primitive).find((each) => each.part === part)?.points ?? [];

/** The primitive with another line in place of one of its own. */
export function withPart({ kind, item }: Primitive, part: Part, points: Point[]): Primitive {
  if (kind === 'stream') return { kind, item: { ...item, points } };
  if (kind === 'parting') return { kind, item: { ...item, points } };
  if (part === 'spine') return { kind, item: { ...item, spine: points } };
  if (part === 'section') return { kind, item: { ...item, section: points } };
  const [first = [], second = []] = item.profiles;
  return { kind, item: { ...item, profiles: part === 'profile-0' ? [points, second] : [first, points] } };
}

/** The line that hair follows: what hint strokes edit. */
export const mainPart = ({ kind }: Primitive): Part => (kind === 'ponytail' ? 'spine' : 'points');

/** The same with every point changed. */
export function mapped(primitive: Primitive, change: (point: Vec3) => Point): Primitive {
  let out = primitive;
  for (const { part, points } of partsOf(primitive)) out = withPart(out, part, points.map(change));
  return out;
}

/** Across x = 0. A parting leans the other way round its normal there. */
export function mirrored(primitive: Primitive): Primitive {
  const image = mapped(primitive, ([x, y, z]) => [-x + 0, y, z]);
  if (image.kind !== 'parting') return image;
  const [a, b] = image.item.tilt;
  return { kind: 'parting', item: { ...image.item, tilt: [-a + 0, -b + 0] } };
}

/** Whether a primitive lies along x = 0 and is its own mirror image for all that matters. */
export const isMiddle = (primitive: Primitive, tolerance: number): boolean =>
  partsOf(primitive)
    .filter(({ part }) => part === mainPart(primitive))
    .every(({ points }) => points.every(([x]) => Math.abs(x) <= tolerance));

/** Number of the primitive that is the exact mirror image of another; −1 if there is none. */
export function twinOf(style: Style, index: number): number {
  const primitives = primitivesOf(style);
  const primitive = primitives[index];
  if (!primitive) return -1;
  const wanted = JSON.stringify(linesOf(mirrored(primitive)));
  return primitives.findIndex((each, i) => i !== index && JSON.stringify(linesOf(each)) === wanted);
}

const linesOf = (primitive: Primitive) => [primitive.kind, partsOf(primitive).map(({ points }) => points)];

export const curveId = (index: number, part: Part): string => `${index}:${part}`;

export function readCurveId(id: string): { readonly index: number; readonly part: Part } {
  const [index, part] = id.split(':');
  return { index: Number(index), part: part as Part };
}

/** What a curve is drawn as: a part of a style, or a hint to one. */
export type CurveKind = 'stream' | 'parting' | 'spine' | 'section' | 'profile' | 'hint';

export const CURVE_LOOKS: Readonly<Record<CurveKind, Pick<ControlLine, 'tint' | 'plain'>>> = {
  stream: { tint: 'blue' },
  parting: { tint: 'yellow' },
  spine: { tint: 'violet' },
  section: { tint: 'green' },
  profile: { tint: 'cyan' },
  hint: { tint: 'coral', plain: true },
};

/** What the view draws of a style. A section is drawn as the ring it is. */
export function curvesOf(style: Style, selected: number | null): ControlLine[] {
  return primitivesOf(style).flatMap((primitive, index) =>
    primitive.item.hidden
      ? []
      : partsOf(primitive).map(({ part, points }) => ({
          id: curveId(index, part),
          points: part === 'section' ? [...points, points[0]!] : points,
          ...CURVE_LOOKS[curveKind(primitive.kind, part)],
          selected: index === selected,
        })),
  );
}

function curveKind(kind: PrimitiveKind, part: Part): CurveKind {
  if (kind !== 'ponytail') return kind;
  return part === 'spine' || part === 'section' ? part : 'profile';
}
