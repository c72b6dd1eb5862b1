// The pointer goes to the tool that is chosen; one handler for the viewport, whichever tool it is.

import type { DeformHost } from '../tools/deform/host';
import { paintHandle, paintRoi } from '../tools/deform/paint-tool';
import { PointTool } from '../tools/deform/point-tool';
import { SelectTool } from '../tools/deform/select-tool';
import type { Tool } from '../tools/tool';
import type { PointerHandler, PointerSample } from '../view/types';
import type { SettingsService } from './api';
import type { State, ToolId } from './state';

export class ToolSwitch implements PointerHandler {
  readonly #tools: Readonly<Record<ToolId, Tool>>;
  /** The tool that has the gesture under way. */
  #held: Tool | null = null;

  constructor(
    private readonly host: DeformHost,
    private readonly state: Pick<State, 'tool'>,
    private readonly settings: SettingsService,
  ) {
    this.#tools = {
      select: new SelectTool(host),
      'paint-roi': paintRoi(host),
      'paint-handle': paintHandle(host),
      'point-handle': new PointTool(host),
    };
  }

  /** Whether a gesture is under way. */
  get busy(): boolean {
    return this.#held !== null;
  }

  down(sample: PointerSample): boolean {
    if (sample.pointerType === 'touch' && this.settings.values.peek().penOnly) return false;
    const tool = this.#tools[this.state.tool.peek()];
    if (!tool.down(sample)) return false;
    this.#held = tool;
    return true;
  }

  move(samples: readonly PointerSample[]): void {
    this.#held?.move(samples);
  }

  up(sample: PointerSample): void {
    const tool = this.#held;
    this.#held = null;
    tool?.up(sample);
  }

  hover(sample: PointerSample): void {
    this.#tools[this.state.tool.peek()].hover(sample);
  }

  leave(): void {
    this.host.view.setBrush(null);
  }

  cancel(): void {
    this.#held?.cancel();
    this.#held = null;
  }
}
