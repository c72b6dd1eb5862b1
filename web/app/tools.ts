// The pointer goes to the tool that is chosen; one handler for the viewport, whichever tool it is.

import type { DeformHost } from '../tools/deform/host';
import { paintHandle, paintRoi } from '../tools/deform/paint-tool';
import { PointTool } from '../tools/deform/point-tool';
import { SelectTool } from '../tools/deform/select-tool';
import type { HairHost } from '../tools/hair/host';
import { PartingTool } from '../tools/hair/parting-tool';
import { PonytailTool } from '../tools/hair/ponytail-tool';
import { paintScalp, type ScalpHost } from '../tools/hair/scalp-tool';
import { HairSelectTool, HintTool } from '../tools/hair/select-tool';
import { StreamTool } from '../tools/hair/stream-tool';
import type { Tool } from '../tools/tool';
import type { PointerHandler, PointerSample, ViewportPort } from '../view/types';
import type { SettingsService } from './api';
import type { State, ToolId } from './state';

interface Parts {
  readonly view: Pick<ViewportPort, 'setBrush'>;
  readonly deform: DeformHost;
  readonly hair: HairHost & ScalpHost;
  readonly state: Pick<State, 'tool' | 'hair'>;
  readonly settings: SettingsService;
}

export class ToolSwitch implements PointerHandler {
  readonly #tools: Readonly<Record<ToolId, Tool>>;
  readonly #ponytail: PonytailTool;
  /** The tool that has the gesture under way. */
  #held: Tool | null = null;

  constructor(private readonly parts: Parts) {
    const { deform, hair } = parts;
    this.#ponytail = new PonytailTool(hair);
    this.#tools = {
      select: new SelectTool(deform),
      'paint-roi': paintRoi(deform),
      'paint-handle': paintHandle(deform),
      'point-handle': new PointTool(deform),
      'hair-select': new HairSelectTool(hair),
      stream: new StreamTool(hair),
      hint: new HintTool(hair),
      parting: new PartingTool(hair),
      ponytail: this.#ponytail,
      'paint-scalp': paintScalp(hair),
    };
  }

  /** Takes back the last stroke of what the tool builds in several. @returns whether there was one */
  back(): boolean {
    return this.parts.state.tool.peek() === 'ponytail' && this.#ponytail.back();
  }

  /** Whether a gesture is under way. */
  get busy(): boolean {
    return this.#held !== null;
  }

  down(sample: PointerSample): boolean {
    const { state, settings } = this.parts;
    if (state.hair.viewed.peek()) return false;
    if (sample.pointerType === 'touch' && settings.values.peek().penOnly) return false;
    const tool = this.#tools[state.tool.peek()];
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
    if (this.parts.state.hair.viewed.peek()) return;
    this.#tools[this.parts.state.tool.peek()].hover(sample);
  }

  leave(): void {
    this.#tools[this.parts.state.tool.peek()].leave();
    this.parts.view.setBrush(null);
  }

  cancel(): void {
    this.#held?.cancel();
    this.#held = null;
  }
}
