import type { ViewSpace } from '../view-space';

/** A way to move all vertices of a model at once, on the graphics card, by a small table a move. */
export interface SurfaceMotion {
  readonly vertexCount: number;
  /** The kernel puts vertices in the same places: what is seen while the hand moves is what remains. */
  readonly exact: boolean;
  /**
   * What the card is given once, for a model drawn in a space.
   *
   * @param widest  of a texture
   * @returns `null` where it has no room for so much
   */
  packed(space: ViewSpace, widest: number): PackedMotion | null;
}

export interface PackedMotion {
  /**
   * GLSL: declares inputs, textures and table by their names and defines
   * `void moved(vec3 place, vec3 normal, out vec3 toPlace, out vec3 toNormal)`, in drawn units.
   */
  readonly glsl: string;
  readonly inputs: readonly VertexInput[];
  readonly textures: readonly MotionTexture[];
  /** A float texture of four numbers a texel. */
  readonly table: { readonly name: string; readonly width: number; readonly height: number };
  /** Its texels for a move, from what `MotionPort.move` was given. */
  readonly tableOf: (move: MotionTable) => Float32Array<ArrayBuffer>;
}

export type MotionTable = Float32Array | Float64Array;

/** Four numbers a vertex: `in vec4` of floats, `in uvec4` of whole numbers. */
export interface VertexInput {
  readonly name: string;
  readonly values: Float32Array | Uint16Array;
}

/** Four numbers a texel: `sampler2D` of floats, `usampler2D` of whole numbers. */
export interface MotionTexture {
  readonly name: string;
  readonly width: number;
  readonly height: number;
  readonly texels: Float32Array<ArrayBuffer> | Uint16Array<ArrayBuffer>;
}

export interface MotionPort {
  /**
   * How the model on screen is moved, kept on the graphics card until another way comes, or another model.
   *
   * @returns whether it can be moved so: the card may have no room for that many numbers
   */
  setMotion(motion: SurfaceMotion | null): boolean;
  /**
   * Moves the surface as of the next picture.
   *
   * @param table  in model space, as the motion reads it; `null`: the shape that was set otherwise
   */
  move(table: MotionTable | null): void;
  /** Goes over to the shape that was set otherwise: within a moment, at once where it is the same. */
  arrive(): void;
  /** Where the graphics card puts the vertices, 3 numbers each in model space, and their normals. For tests, and slow. */
  readBack(): { readonly positions: Float64Array; readonly normals: Float32Array } | null;
}
