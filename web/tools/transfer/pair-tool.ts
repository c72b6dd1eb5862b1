// Says which part of the target a handle's counterpart is: painted like a region, or clicked where the handle is a point.

import { toIndices } from '../../core/vertex-set';
import type { PointerSample } from '../../view/types';
import { PaintTool } from '../paint-tool';
import type { Tool } from '../tool';
import { counterpartAt, nextOpen, pairing } from './edits';
import type { TransferHost, TransferScene } from './host';

/** Belongs to the selected handle; without one to the counterpart under the pointer, else to the next open handle. */
function handleFor({ step, handles, selected }: TransferScene, vertex: number): number | null {
  if (selected !== null && selected < handles.length) return selected;
  const under = counterpartAt(step, vertex);
  return under >= 0 ? under : nextOpen(pairing(step, handles).open, null);
}

export class PairTool implements Tool {
  readonly #brush: PaintTool<TransferScene>;
  /** The handle that the gesture under way is for. */
  #handle = 0;
  #tool: Tool | null = null;

  constructor(private readonly host: TransferHost) {
    this.#brush = new PaintTool(host, {
      kind: 'counterpart',
      scene: () => host.scene(),
      canvas: ({ step, count }) => {
        const handle = this.#handle;
        return {
          base: toIndices(step.handles[handle] ?? [], count),
          commit: (verb, vertices) => host.commit(verb, handle, vertices),
        };
      },
    });
  }

  down(sample: PointerSample): boolean {
    const scene = this.host.scene();
    if (!scene || sample.button !== 0 || !sample.hit) return false;
    const handle = handleFor(scene, sample.hit.vertex);
    if (handle === null) return false;
    this.#handle = handle;
    if (handle !== scene.selected) this.host.pick(handle);
    const isPoint = scene.handles[handle]!.kind === 'point';
    const tool = isPoint ? new PointPlacing(this.host, handle) : this.#brush;
    if (!tool.down(sample)) return false;
    this.#tool = tool;
    return true;
  }

  move(samples: readonly PointerSample[]): void {
    this.#tool?.move(samples);
  }

  up(sample: PointerSample): void {
    const tool = this.#tool;
    this.#tool = null;
    tool?.up(sample);
  }

  hover(sample: PointerSample): void {
    const scene = this.host.scene();
    if (scene?.selected != null && scene.handles[scene.selected]?.kind === 'point') this.#brush.leave();
    else this.#brush.hover(sample);
  }

  leave(): void {
    this.#brush.leave();
  }

  cancel(): void {
    this.#tool?.cancel();
    this.#tool = null;
  }
}

/** One vertex, where the pointer is let go. */
class PointPlacing implements Tool {
  #vertex: number | null = null;

  constructor(
    private readonly host: TransferHost,
    private readonly handle: number,
  ) {}

  down(sample: PointerSample): boolean {
    this.#follow(sample);
    return true;
  }

  move(samples: readonly PointerSample[]): void {
    const sample = samples.at(-1);
    if (sample) this.#follow(sample);
  }

  up(sample: PointerSample): void {
    this.#follow(sample);
    if (this.#vertex !== null) this.host.commit('paint', this.handle, Uint32Array.of(this.#vertex));
    this.host.showPaint(null);
  }

  hover(): void {}

  leave(): void {}

  cancel(): void {
    this.host.showPaint(null);
  }

  #follow({ hit }: PointerSample): void {
    if (hit) this.#vertex = hit.vertex;
    if (this.#vertex !== null)
      this.host.showPaint({ kind: 'counterpart', vertices: Uint32Array.of(this.#vertex) });
  }
}
