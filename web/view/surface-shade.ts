import type { IUniform } from 'three';

/** What a layer adds to the look of every surface: GLSL for the surface materials, in terms of theirs. */
export interface SurfaceShade {
  /** Stands for the code: two with the same have the same code and the same uniforms' names. */
  readonly id: string;
  readonly uniforms: Readonly<Record<string, IUniform>>;
  /** Before `main` of the vertices; attributes, varyings. */
  readonly vertexDeclarations: string;
  /** In `main` of the vertices. */
  readonly vertexBody: string;
  /** Before `main` of the fragments. */
  readonly declarations: string;
  /** Changes `base`, the surface's own linear colour. */
  readonly colour: string;
  /** Changes `reflectedLight`, after all of it has been gathered; the drawn place is `vPlace`. */
  readonly light: string;
  /** Changes `gl_FragColor` as the screen shows it, before lines and brush lie over it; nothing where left out. */
  readonly finish?: string;
}
