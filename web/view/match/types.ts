// What the floors above know of skins in the picture.

/** A surface over the model, as it is or while it grows. */
export interface Skin {
  readonly triangles: Uint32Array;
  /** 3 per vertex, model space. */
  readonly positions: Float64Array;
}

export interface SkinLook {
  readonly skin: Skin;
  /** In place of the model; else a veil over it. */
  readonly alone: boolean;
  /** Its edges, by which one connectivity can be seen on several models. */
  readonly edges: boolean;
  /** In [0, 1] per vertex: coloured by the heat map's warm half. */
  readonly heat?: Float32Array | undefined;
}

export interface SkinPort {
  setSkin(look: SkinLook | null): void;
}
