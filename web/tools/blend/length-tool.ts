// A length between two clicks: along edges of the skin, or with Shift straight through.

import type { PointerSample } from '../../view/types';
import { PickTool } from '../pick-tool';
import type { BlendHost } from './host';

export class LengthTool extends PickTool {
  constructor(private readonly blend: BlendHost) {
    super({
      at: ({ hit }) => (blend.scene() && hit ? hit.vertex : null),
      pick: (vertex, { shift }) => {
        const from = blend.lengthFrom();
        if (from === null) blend.beginLength(vertex);
        else if (vertex !== from) blend.measureLength(from, vertex, shift);
      },
    });
  }

  /** What a second click would measure. */
  override hover({ hit, shift }: PointerSample): void {
    const from = this.blend.lengthFrom();
    if (from === null) return;
    this.blend.showLength(hit && hit.vertex !== from ? { from, to: hit.vertex, straight: shift } : null);
  }

  override leave(): void {
    this.blend.showLength(null);
  }
}
