// What tools that paint on a surface need of the app, whichever wing they belong to.

import type { ReadonlySignal } from '@preact/signals';
import type { ModelResult } from '../run/types';
import type { Brush, PaintScene } from '../tools/brush-stroke';
import { EdgeGraph } from '../tools/edge-graph';
import { MeshGraph } from '../tools/mesh-graph';
import { Mirror } from '../tools/mirror';
import type { State } from './state';

export const brushOf = ({ brushSize, brushMode }: Pick<State, 'brushSize' | 'brushMode'>): Brush => ({
  radius: brushSize.peek(),
  erase: brushMode.peek() === 'erase',
});

/** Neighbours and mirror images of a model's vertices, worked out once per model, when a tool first needs them. */
export class SurfaceAids {
  #of: ModelResult['opened'] | null = null;
  #graph: MeshGraph | undefined;
  #mirror: Mirror | undefined;
  #edges: { readonly of: ModelResult['opened']; readonly graph: EdgeGraph } | undefined;

  /** @param mirroring  whether strokes are mirrored, asked at each */
  of({ model, opened }: ModelResult, mirroring: ReadonlySignal<boolean>): PaintScene {
    if (this.#of !== opened) {
      this.#of = opened;
      this.#graph = undefined;
      this.#mirror = undefined;
    }
    this.#graph ??= new MeshGraph(opened);
    return {
      graph: this.#graph,
      mirrored: (vertices) => {
        if (!mirroring.peek()) return vertices;
        this.#mirror ??= new Mirror(model.positions);
        return this.#mirror.both(vertices);
      },
    };
  }

  /** Edges at rest. */
  edgesOf({ model, opened }: ModelResult): EdgeGraph {
    if (this.#edges?.of !== opened)
      this.#edges = { of: opened, graph: new EdgeGraph({ ...opened, positions: model.positions }) };
    return this.#edges!.graph;
  }
}
