// The pointer goes to the tool that is chosen; one handler for a viewport, whichever tool it is.

import type { DeformHost } from '../tools/deform/host';
import { paintHandle, paintRoi } from '../tools/deform/paint-tool';
import { PointTool } from '../tools/deform/point-tool';
import { SelectTool } from '../tools/deform/select-tool';
import type { HairHost } from '../tools/hair/host';
import { type LengthHost, paintLength } from '../tools/hair/length-tool';
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
  readonly lengths: LengthHost;
  readonly state: Pick<State, 'tool' | 'hair'>;
  readonly settings: SettingsService;
}

/** Gives the pointer of a viewport to the tool that is chosen, and keeps a gesture with the tool that began it. */
export class PointerSwitch implements PointerHandler {
  /** The tool that has the gesture under way. */
  #held: Tool | null = null;

  /** @param chosen  undefined where the chosen tool has nothing to do here: then only the camera moves */
  constructor(
    private readonly view: Pick<ViewportPort, 'setBrush'>,
    private readonly chosen: () => Tool | undefined,
    private readonly settings: SettingsService,
  ) {}

  /** Whether a gesture is under way. */
  get busy(): boolean {
    return this.#held !== null;
  }

  down(sample: PointerSample): boolean {
    if (sample.pointerType === 'touch' && this.settings.values.peek().penOnly) return false;
    const tool = this.chosen();
    if (!tool?.down(sample)) return false;
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
    this.chosen()?.hover(sample);
  }

  leave(): void {
    this.chosen()?.leave();
    this.view.setBrush(null);
  }

  /** @returns whether there was a gesture to end */
  cancel(): boolean {
    const { busy } = this;
    this.#held?.cancel();
    this.#held = null;
    return busy;
  }
}

/** The pointer of the main viewport. In the merge workspace the two models have panes of their own. */
export class ToolSwitch extends PointerSwitch {
  readonly #ponytail: PonytailTool;

  constructor(private readonly parts: Parts) {
    const { deform, hair, lengths } = parts;
    const ponytail = new PonytailTool(hair);
    const tools: Readonly<Partial<Record<ToolId, Tool>>> = {
      select: new SelectTool(deform),
      'paint-roi': paintRoi(deform),
      'paint-handle': paintHandle(deform),
      'point-handle': new PointTool(deform),
      'hair-select': new HairSelectTool(hair),
      stream: new StreamTool(hair),
      hint: new HintTool(hair),
      parting: new PartingTool(hair),
      ponytail,
      'paint-scalp': paintScalp(hair),
      'paint-length': paintLength(lengths),
    };
    const { state } = parts;
    super(
      parts.view,
      () => (state.hair.viewed.peek() ? undefined : tools[state.tool.peek()]),
      parts.settings,
    );
    this.#ponytail = ponytail;
  }

  /** Takes back the last stroke of what the tool builds in several. @returns whether there was one */
  back(): boolean {
    return this.parts.state.tool.peek() === 'ponytail' && this.#ponytail.back();
  }
}
