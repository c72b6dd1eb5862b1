import type { ReadonlySignal } from '@preact/signals';
import type { ModelResult } from '../../run/types';
import { type Loop, openLoops } from '../../tools/merge/loops';
import type { MergeSide } from '../../tools/merge/pins';
import { MeshGraph } from '../../tools/mesh-graph';
import type { Sides } from './state';

export interface SideAid {
  readonly positions: Float64Array;
  readonly graph: MeshGraph;
  /** The model's openings. */
  readonly loops: readonly Loop[];
}

/** What is worked out once per model of the two, when it is first needed. */
export class Aids {
  readonly #held = new Map<MergeSide, { readonly of: ModelResult['opened']; readonly aid: SideAid }>();

  constructor(private readonly sides: ReadonlySignal<Sides>) {}

  of(side: MergeSide): SideAid | null {
    const model = this.sides.peek()[side];
    if (!model) return null;
    const held = this.#held.get(side);
    if (held?.of === model.opened) return held.aid;
    const { opened } = model;
    const { positions } = model.model;
    const aid = { positions, graph: new MeshGraph(opened), loops: openLoops(opened) };
    this.#held.set(side, { of: opened, aid });
    return aid;
  }
}
