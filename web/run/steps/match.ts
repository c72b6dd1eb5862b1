// The match step: skins of one connectivity over several models (Skins).

import { type Finding, LissomError } from '../../core/errors';
import { type Model, type Morph, vertexCount } from '../../core/model';
import type { Rig } from '../../core/rig';
import { isEmpty, toIndices, type VertexSet } from '../../core/vertex-set';
import type { Matched, SkinFigures } from '../../kernel/contract/match';
import { isDrawn, isWhole, type MarkerPlace, type MatchStep } from '../../recipe/steps/match';
import { carriedRig } from '../carried-rig';
import type { ModelResult } from '../types';
import { checkVertices, vertexSetKey } from '../vertex-sets';
import { askedPoints, hasAttributes, readAttributes, type SkinAttributes } from './match/attributes';
import { carriedMorphs, readMorphs } from './match/morphs';
import { placePoints } from './match/places';
import { matchQuestions } from './match/questions';
import { readRig } from './match/rig';
import {
  type InputShape,
  type StepContext,
  type StepOutcome,
  type StepRunner,
  signalOf,
} from './step-runner';

/** With one or two markers it is open how the models are turned: none at all, or so many. */
const FEWEST_MARKERS = 3;

export interface MatchFigures {
  /** Largest distance of a marker from its place, in diagonals. */
  readonly markerError: number;
  /** By model, in diagonals of it. */
  readonly distance: Readonly<Record<string, SkinFigures['distance']>>;
  readonly flipped: Readonly<Record<string, number>>;
  readonly folds: Readonly<Record<string, number>>;
  readonly selfIntersections: Readonly<Record<string, number>>;
  /** By model, of those with sharp edges. */
  readonly sharp: Readonly<Record<string, NonNullable<SkinFigures['sharp']>>>;
  readonly iterations: number;
}

/** What a match leaves beside the skins, for who looks at it. */
export interface MatchQuality {
  /** By model: how far each vertex of its skin lies from it, in diagonals. */
  readonly residuals: Readonly<Record<string, Float32Array>>;
  /** By model: vertices of its skin where another marker would help most. */
  readonly poorest: Readonly<Record<string, Uint32Array>>;
  /** The skins' vertex that each marker is. */
  readonly markerVertices: Uint32Array;
}

const qualities = new WeakMap<Model, MatchQuality>();

/** What is known of a match by the skin of its first model: the `model` of its result. */
export const matchQuality = (skin: Model): MatchQuality | undefined => qualities.get(skin);

export const matchRunner = {
  check(step, path, inputs) {
    checkCounts(step, path);
    const { length } = step.markers.filter(isWhole);
    if (length > 0 && length < FEWEST_MARKERS)
      throw new LissomError(
        'marker-count',
        `${path}.markers: there ${length === 1 ? 'is one' : 'are two'}; give ${FEWEST_MARKERS} or more, or none at all.`,
      );
    for (const [at, input] of inputs.entries()) {
      if (!input) continue;
      for (const [number, places] of step.markers.entries())
        checkPlace(places[at] ?? null, `${path}.markers[${number}][${at}]`, input);
      for (const [number, rows] of (step.curves ?? []).entries())
        for (const [along, place] of rows[at]!.entries())
          checkPlace(place, `${path}.curves[${number}][${at}][${along}]`, input);
      for (const [number, row] of (step.sharp?.[at] ?? []).entries())
        checkVertices(row, `${path}.sharp[${at}][${number}]`, input);
      const mask = step.mask?.[at];
      if (mask) checkVertices(mask, `${path}.mask[${at}]`, input);
    }
  },

  /** Edges are split and collapsed: nobody knows before. */
  vertexCount: () => undefined,

  content: ({ id: _id, models: _models, mask, ...rest }) => ({
    ...rest,
    mask: mask?.map(vertexSetKey),
  }),

  async run(step, context): Promise<StepOutcome<MatchFigures>> {
    const { inputs, onProgress, onLook } = context;
    const numbers = [...step.markers.keys()].filter((number) => isWhole(step.markers[number]!));
    const markers = numbers.map((number) => step.markers[number]!);
    const curves = (step.curves ?? []).filter(isDrawn);
    const models = inputs.map(({ model, opened }, at) => ({
      model: opened.id,
      markers: placePoints(
        model,
        markers.map((places) => places[at]!),
        inputName(step, at),
      ),
      ignored: indicesOf(step.mask?.[at] ?? [], model),
      curves: curves.map((rows) => placePoints(model, rows[at]!, inputName(step, at))),
      sharp: (step.sharp?.[at] ?? []).map((row) => Uint32Array.from(row)),
    }));
    const { edgeLength, adapt, sharpAngle, first, genus, method, together, start } = step;
    const matched = await context.kernel.call(
      'match',
      { models, options: { edgeLength, adapt, sharpAngle, first, genus, method, together, start } },
      { ...signalOf(context), onProgress, ...(onLook && { onLook }) },
    );
    const { triangles, attributes, morphs, rig } = await carriedFrom(inputs[0]!, matched, context);
    const [source] = matched.positions;
    const morphsAt = (at: number) =>
      at === 0 ? morphs : carriedMorphs(morphs, triangles, source!, matched.positions[at]!);
    const rigAt = (of: Rig, at: number) =>
      at === 0 ? of : carriedRig(of, triangles, source!, matched.positions[at]!);
    const skins = step.models.map((name, at) => ({
      ...skinOf(name, triangles, matched.positions[at]!),
      ...attributes,
      ...(morphs.length > 0 && { morphs: morphsAt(at) }),
      ...(rig && { rig: rigAt(rig, at) }),
    }));
    const byName = <T>(value: (at: number) => T): Record<string, T> =>
      Object.fromEntries(step.models.map((name, at) => [name, value(at)]));
    qualities.set(skins[0]!, {
      residuals: byName((at) => matched.residuals[at]!),
      poorest: byName((at) => matched.poorest[at]!),
      markerVertices: matched.markerVertices,
    });
    const { figures } = matched;
    return {
      model: skins[0]!,
      models: byName((at) => skins[at]!),
      figures: {
        markerError: matched.markerError,
        distance: byName((at) => figures[at]!.distance),
        flipped: byName((at) => figures[at]!.flipped),
        folds: byName((at) => figures[at]!.folds),
        selfIntersections: byName((at) => figures[at]!.selfIntersections),
        sharp: Object.fromEntries(
          step.models.flatMap((name, at) => (figures[at]!.sharp ? [[name, figures[at]!.sharp]] : [])),
        ),
        iterations: matched.iterations,
      },
      seconds: { ...matched.seconds },
      peakBytes: matched.peakBytes,
      warnings: [
        ...matched.warnings.map(({ model, examples, ...rest }) => ({
          ...rest,
          // The kernel counts the markers that are placed everywhere.
          examples: rest.code.startsWith('markers-') ? examples.map((at) => numbers[at]!) : examples,
          ...(model >= 0 && { model: step.models[model]! }),
        })),
        ...leftOut(step),
      ],
    };
  },
  questions: matchQuestions,
} satisfies StepRunner<MatchStep>;

/** What waits for its place on another model. */
function leftOut({ markers, curves = [] }: MatchStep): Finding[] {
  const numbers = markers.flatMap((marker, number) => (isWhole(marker) ? [] : [number]));
  const lines = curves.flatMap((rows, number) => (isDrawn(rows) ? [] : [number]));
  const finding = (code: string, examples: readonly number[]): Finding[] =>
    examples.length > 0 ? [{ code, count: examples.length, examples, repaired: false }] : [];
  return [...finding('marker-incomplete', numbers), ...finding('curve-incomplete', lines)];
}

const inputName = ({ models }: MatchStep, at: number): string => models[at]!;

const indicesOf = (set: VertexSet, model: Model): Uint32Array =>
  isEmpty(set) ? new Uint32Array() : toIndices(set, vertexCount(model));

function skinOf(name: string, triangles: Uint32Array, positions: Float64Array): Model {
  const count = triangles.length / 3;
  return {
    name: name.slice(name.lastIndexOf('/') + 1),
    positions,
    faceOffsets: Uint32Array.from({ length: count + 1 }, (_, face) => 3 * face),
    faceVertices: triangles,
  };
}

/** What the source has beside its shape, for every skin; its groups decide the order of their triangles. */
async function carriedFrom(
  source: ModelResult,
  { triangles, positions }: Matched,
  context: StepContext,
): Promise<{
  readonly triangles: Uint32Array;
  readonly attributes: SkinAttributes;
  /** Of the first skin. */
  readonly morphs: readonly Morph[];
  /** Of the first skin. */
  readonly rig?: Rig | undefined;
}> {
  if (!hasAttributes(source.model)) return { triangles, attributes: {}, morphs: [] };
  const asked = askedPoints(positions[0]!, triangles);
  const places = (points: Float64Array) =>
    context.kernel.call('placesOn', { model: source.opened.id, points }, signalOf(context));
  const vertices = await places(asked.vertices);
  const { attributes, order } = readAttributes(source, asked, {
    vertices,
    corners: await places(asked.corners),
    middles: await places(asked.middles),
  });
  const morphs = readMorphs(source, vertices);
  const rig = readRig(source, vertices);
  return { triangles: order ? inOrder(triangles, order) : triangles, attributes, morphs, rig };
}

const inOrder = (triangles: Uint32Array, order: Uint32Array): Uint32Array =>
  Uint32Array.from(triangles, (_, corner) => triangles[3 * order[Math.floor(corner / 3)]! + (corner % 3)]!);

/** @throws LissomError `index-out-of-range` */
function checkPlace(place: MarkerPlace | null, path: string, input: InputShape): void {
  if (typeof place === 'number') checkVertices([place], path, input);
}

/** Lists that have an entry for each model. @throws LissomError `marker-count` */
function checkCounts({ models, markers, curves = [], sharp, mask }: MatchStep, path: string): void {
  const wrong = (field: string, found: number, what: string) =>
    new LissomError(
      'marker-count',
      `${path}.${field}: expected ${models.length}, one ${what} for each model in their order, but found ${found}.`,
    );
  for (const [at, { length }] of markers.entries())
    if (length !== models.length) throw wrong(`markers[${at}]`, length, 'place');
  for (const [at, { length }] of curves.entries())
    if (length !== models.length) throw wrong(`curves[${at}]`, length, 'row of places');
  if (sharp && sharp.length !== models.length) throw wrong('sharp', sharp.length, 'list');
  if (mask && mask.length !== models.length) throw wrong('mask', mask.length, 'vertex set');
}
