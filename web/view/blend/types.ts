/** Of which functions of a field value the controls are the coefficients. */
export type BlendBasis = 'quadratic' | 'hats';

/**
 * What a surface is moved by: x′ = x + Σ_i φ_i Σ_j b_j(φ_i) d_ij (x, 1), a transformation's offset d for each control, or
 * with a single set x′ = x + Σ_j b_j(φ) d_j (x, 1) (Isolines 4.1).
 */
export interface BlendSurface {
  /** Sets of controls, each with a field of its own. */
  readonly sets: number;
  /** One set that is not weighted by its field, as for two handles that mirror each other. */
  readonly single: boolean;
  readonly basis: BlendBasis;
  /** Of each set. */
  readonly controls: number;
  /** Sets of numbers per vertex, vertex by vertex: its value in each field, in [0, 1]. */
  readonly fields: Float32Array;
  /** The fields' gradients on the surface, 1 per model unit: 3 numbers per field, vertex by vertex. */
  readonly gradients: Float32Array;
  /** Vertices that stay where they are, one flag each; left out: none. */
  readonly still?: Uint8Array;
}

export interface BlendPort {
  /**
   * The fields of the model on screen, kept on the graphics card until others come, or another model.
   *
   * @returns whether it can be moved so: the card may have no room for that many numbers
   */
  setSurface(surface: BlendSurface | null): boolean;
  /**
   * Moves the surface as of the next picture.
   *
   * @param offsets  12 numbers a control, rows of [A − 1 | b] in model space; `null`: the shape that was set otherwise
   */
  move(offsets: Float64Array | null): void;
  /** Goes over to the shape that was set otherwise, within a moment. */
  arrive(): void;
  /** Where the graphics card puts the vertices, 3 numbers each in model space, and their normals. For tests, and slow. */
  readBack(): { readonly positions: Float64Array; readonly normals: Float32Array } | null;
}
