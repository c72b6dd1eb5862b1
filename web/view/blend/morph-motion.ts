// A blend of shapes as the graphics card takes it: the shapes once, weights a move.

import type { MotionTable, MotionTexture, PackedMotion, SurfaceMotion } from '../motion/types';
import { VertexNormals } from '../normals';
import type { ViewSpace } from '../view-space';
import { morphGlsl } from './morph-glsl';

export interface MorphShapes {
  /** Of each shape: 3 per vertex. */
  readonly positions: readonly Float64Array[];
  readonly triangles: Uint32Array;
  /** Added whatever the weights are, 3 per vertex: what the exact result has beside the sum. */
  readonly beside?: Float64Array | undefined;
}

/** Moves it by a weight a shape. */
export class MorphMotion implements SurfaceMotion {
  constructor(readonly shapes: MorphShapes) {}

  /** A sum is a sum; what comes beside changes with the weights. */
  get exact(): boolean {
    return this.shapes.beside === undefined;
  }

  get vertexCount(): number {
    return this.shapes.positions[0]!.length / 3;
  }

  packed(space: ViewSpace, widest: number): PackedMotion | null {
    const { positions, beside } = this.shapes;
    const count = positions.length + (beside ? 1 : 0);
    const origin = space.toView([0, 0, 0]).toArray() as [number, number, number];
    const texture = packShapes(this.shapes, space, widest);
    if (!texture || count > widest) return null;
    return {
      glsl: morphGlsl(count, origin),
      inputs: [],
      textures: [{ name: 'morphShapes', ...texture }],
      table: { name: 'morphWeights', width: count, height: 1 },
      tableOf: (weights) => weightTexels(weights, positions.length, count),
    };
  }
}

/** Of each shape its weight, and 1 where it counts from the model's origin. */
function weightTexels(weights: MotionTable, shapes: number, count: number): Float32Array<ArrayBuffer> {
  const out = new Float32Array(4 * count);
  for (let i = 0; i < count; i++) {
    out[4 * i] = i < shapes ? weights[i]! : 1;
    out[4 * i + 1] = i < shapes ? 1 : 0;
  }
  return out;
}

/** @param widest  of a texture. @returns `null` where they do not fit into one */
export function packShapes(
  { positions, triangles, beside }: MorphShapes,
  space: ViewSpace,
  widest: number,
): Pick<MotionTexture, 'width' | 'height' | 'texels'> | null {
  const vertices = positions[0]!.length / 3;
  const shapes = positions.length + (beside ? 1 : 0);
  const count = 2 * vertices * shapes;
  const width = Math.max(1, Math.min(widest, count));
  const height = Math.max(1, Math.ceil(count / width));
  if (height > widest) return null;
  const texels = new Float32Array(4 * width * height);
  const normals = new VertexNormals(
    triangles,
    Int32Array.from({ length: vertices }, (_, v) => v),
  );
  const places = new Float32Array(3 * vertices);
  const facing = new Float32Array(3 * vertices);
  const put = (shape: number): void => {
    for (let v = 0; v < vertices; v++) {
      const at = 8 * (v * shapes + shape);
      texels.set(places.subarray(3 * v, 3 * v + 3), at);
      texels.set(facing.subarray(3 * v, 3 * v + 3), at + 4);
    }
  };
  for (const [shape, each] of positions.entries()) {
    space.place(each, places);
    normals.compute(places, facing);
    put(shape);
  }
  if (beside) {
    facing.fill(0);
    for (let v = 0; v < vertices; v++) {
      const drawn = space.directionToView([beside[3 * v]!, beside[3 * v + 1]!, beside[3 * v + 2]!]);
      places.set(drawn.multiplyScalar(space.scale).toArray(), 3 * v);
    }
    put(shapes - 1);
  }
  return { width, height, texels };
}
