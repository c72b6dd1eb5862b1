import { LissomError } from '../../../core/errors';
import { faceCount, type Model } from '../../../core/model';
import type { MarkerPlace } from '../../../recipe/steps/match';

/**
 * Places of a model as points: 3 numbers each.
 *
 * @param name  the model's, for who has to mend one
 * @throws LissomError `index-out-of-range`, `weight-count`
 */
export function placePoints(model: Model, places: readonly MarkerPlace[], name: string): Float64Array {
  const points = new Float64Array(3 * places.length);
  for (const [at, place] of places.entries()) points.set(placePoint(model, place, name), 3 * at);
  return points;
}

export function placePoint(
  model: Model,
  place: MarkerPlace,
  name: string,
): readonly [number, number, number] {
  if (typeof place === 'number') return vertexAt(model, place);
  if ('point' in place) return place.point;
  const faces = faceCount(model);
  if (place.face >= faces)
    throw new LissomError(
      'index-out-of-range',
      `A marker names face ${place.face}, but ${JSON.stringify(name)} has ${faces} faces, numbered 0 to ${faces - 1}.`,
    );
  const corners = model.faceVertices.subarray(
    model.faceOffsets[place.face],
    model.faceOffsets[place.face + 1],
  );
  if (corners.length !== place.at.length)
    throw new LissomError(
      'weight-count',
      `A marker has ${place.at.length} weights on face ${place.face} of ${JSON.stringify(name)}, which has ${corners.length} corners; give one for each.`,
    );
  const sum: [number, number, number] = [0, 0, 0];
  for (const [corner, vertex] of corners.entries())
    for (const [axis, value] of vertexAt(model, vertex).entries()) sum[axis]! += place.at[corner]! * value;
  return sum;
}

const vertexAt = ({ positions }: Model, vertex: number): readonly [number, number, number] => [
  positions[3 * vertex]!,
  positions[3 * vertex + 1]!,
  positions[3 * vertex + 2]!,
];
