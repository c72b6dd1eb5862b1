// A large model out of a small one: subdivided, and scales put on its skin. Made where it is wanted instead of shipped.

import { boxOf, sizeOf } from '../box';
import { LissomError } from '../errors';
import type { Model } from '../model';
import { cells } from './cells';
import { loopSubdivided, type Surface } from './loop';

/** How a model is made larger. */
export interface Scaling {
  /** Times that each triangle is cut into four. */
  readonly subdivisions: number;
  readonly scales: {
    /** Of a scale, in diagonals of the model's box. */
    readonly size: number;
    /** Of a scale above the grooves between, in their size. */
    readonly height: number;
    /** As much of it where the surface looks down. */
    readonly below: number;
  };
}

/** Vertices between two reports. */
const SLICE = 16_384;
/** Shares of the work. */
const SUBDIVIDED = 0.4;
/** Width of the grooves, in the difference of the distances from two seeds. */
const GROOVE = 0.35;

/**
 * In slices: yields how far it is, in [0, 1], and returns the model. Deterministic to the last bit.
 *
 * @throws LissomError `not-triangles`
 */
export function* scaled(model: Model, { subdivisions, scales }: Scaling): Generator<number, Model> {
  let surface = surfaceOf(model);
  for (let level = 0; level < subdivisions; level++) {
    yield (SUBDIVIDED * level) / subdivisions;
    surface = loopSubdivided(surface);
  }
  yield SUBDIVIDED;
  const { corners } = surface;
  const positions = yield* withScales(surface, scales);
  const ordered = inOrderOfUse({ positions, corners });
  return {
    name: model.name,
    positions: ordered.positions,
    faceOffsets: new Uint32Array(corners.length / 3 + 1).map((_, face) => 3 * face),
    faceVertices: ordered.corners,
    ...(model.upAxis && { upAxis: model.upAxis }),
    ...(model.unitMetres && { unitMetres: model.unitMetres }),
  };
}

function surfaceOf({ name, positions, faceOffsets, faceVertices }: Model): Surface {
  if (faceOffsets.some((offset, face) => offset !== 3 * face))
    throw new LissomError(
      'not-triangles',
      `${name} has faces of other than three corners; give its triangles.`,
    );
  return { positions, corners: faceVertices };
}

/** Domes along the normals, with grooves between: flat at a cell's border, rounded within. */
function* withScales(
  { positions, corners }: Surface,
  { size, height, below }: Scaling['scales'],
): Generator<number, Float64Array> {
  const box = boxOf(positions);
  const { low, high } = box;
  const [x, y, z] = sizeOf(box);
  const edge = size * Math.sqrt(x * x + y * y + z * z); // not hypot, whose last bit is the engine's own
  const nearest = cells(low, high, edge);
  const normals = normalsOf({ positions, corners });
  const raised = positions.slice();
  for (let v = 0; 3 * v < positions.length; v++) {
    if (v % SLICE === 0) yield SUBDIVIDED + ((1 - SUBDIVIDED) * 3 * v) / positions.length;
    const at = 3 * v;
    const { first, second } = nearest(positions[at]!, positions[at + 1]!, positions[at + 2]!);
    const side = smoothStep((second - first) / GROOVE);
    const dome = side * (1 - 0.4 * first * first);
    const up = smoothStep(normals[at + 1]! + 1);
    const rise = edge * height * dome * (below + (1 - below) * up);
    for (let k = 0; k < 3; k++) raised[at + k]! += rise * normals[at + k]!;
  }
  return raised;
}

const smoothStep = (x: number): number => {
  const t = Math.min(1, Math.max(0, x));
  return t * t * (3 - 2 * t);
};

/** Unit normals of the vertices: the mean of their triangles', by area. Zero where there is none. */
function normalsOf({ positions, corners }: Surface): Float64Array {
  const normals = new Float64Array(positions.length);
  for (let c = 0; c < corners.length; c += 3) {
    const p = 3 * corners[c]!;
    const q = 3 * corners[c + 1]!;
    const r = 3 * corners[c + 2]!;
    const ax = positions[q]! - positions[p]!;
    const ay = positions[q + 1]! - positions[p + 1]!;
    const az = positions[q + 2]! - positions[p + 2]!;
    const bx = positions[r]! - positions[p]!;
    const by = positions[r + 1]! - positions[p + 1]!;
    const bz = positions[r + 2]! - positions[p + 2]!;
    for (let corner = 0; corner < 3; corner++) {
      const at = 3 * corners[c + corner]!;
      normals[at]! += ay * bz - az * by;
      normals[at + 1]! += az * bx - ax * bz;
      normals[at + 2]! += ax * by - ay * bx;
    }
  }
  for (let v = 0; v < normals.length; v += 3) {
    const x = normals[v]!;
    const y = normals[v + 1]!;
    const z = normals[v + 2]!;
    const length = Math.sqrt(x * x + y * y + z * z);
    for (let k = 0; k < 3; k++) normals[v + k] = length > 0 ? normals[v + k]! / length : 0;
  }
  return normals;
}

/** Vertices numbered as the triangles come by them: what lies together has numbers together, so that sets are short to write. */
function inOrderOfUse({ positions, corners }: Surface): Surface {
  const place = new Int32Array(positions.length / 3).fill(-1);
  const ordered = new Float64Array(positions.length);
  let next = 0;
  const take = (v: number) => {
    for (let k = 0; k < 3; k++) ordered[3 * next + k] = positions[3 * v + k]!;
    place[v] = next++;
  };
  for (let c = 0; c < corners.length; c++) if (place[corners[c]!] === -1) take(corners[c]!);
  for (let v = 0; v < place.length; v++) if (place[v] === -1) take(v);
  return { positions: ordered, corners: corners.map((v) => place[v]!) };
}
