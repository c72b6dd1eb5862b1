/**
 * What a surface is moved by: x′ = x + Σ_i φ_i Σ_j b_j(φ_i) d_ij (x, 1), a transformation's offset d for each control, or
 * with a single set x′ = x + Σ_j b_j(φ) d_j (x, 1) (Isolines 4.1).
 */
export interface IsolineSurface {
  /** Sets of controls, each with a field of its own. */
  readonly sets: number;
  /** One set that is not weighted by its field, as for two handles that mirror each other. */
  readonly single: boolean;
  /** Of which functions of a field value the controls are the coefficients. */
  readonly basis: 'quadratic' | 'hats';
  /** Of each set. */
  readonly controls: number;
  /** Sets of numbers per vertex, vertex by vertex: its value in each field, in [0, 1]. */
  readonly fields: Float32Array;
  /** The fields' gradients on the surface, 1 per model unit: 3 numbers per field, vertex by vertex. */
  readonly gradients: Float32Array;
  /** Vertices that stay where they are, one flag each; left out: none. */
  readonly still?: Uint8Array;
}
