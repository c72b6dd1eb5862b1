// The hair workspace on screen: strands, curves, supporting surfaces, painted skin, one effect per thing drawn, and
// the tools.

import { effect } from '@preact/signals';
import { strandCount } from '../../core/strands';
import { scalpOf } from '../../run/steps/hair/scalp';
import { paintLength } from '../../tools/hair/length-tool';
import { PartingTool } from '../../tools/hair/parting-tool';
import { PonytailTool, ponytailStage } from '../../tools/hair/ponytail-tool';
import { paintScalp } from '../../tools/hair/scalp-tool';
import { HairSelectTool, HintTool } from '../../tools/hair/select-tool';
import { StreamTool } from '../../tools/hair/stream-tool';
import { CURVE_LOOKS, curvesOf } from '../../tools/hair/style';
import type { ViewportPort } from '../../view/types';
import type { Mounted } from '../wing';
import type { WingParts } from '../wing-parts';
import { syncField } from './field-sync';
import { AppHairHost } from './host';
import { layersIn } from './layers';
import { AppLengthHost } from './length-host';
import { LENGTHS, SPARSE, shownLengths } from './lengths';
import { type FirstSight, frameHair } from './opening';
import type { HairState } from './state';

type Parts = Pick<WingParts, 'state' | 'document' | 'evaluator' | 'runner' | 'messages'>;

export function mountHair(viewport: ViewportPort, parts: Parts, own: HairState, sight: FirstSight): Mounted {
  const { state, evaluator } = parts;
  const layers = layersIn(viewport);
  const { hair, curves, support } = layers.ports;
  const host = new AppHairHost(viewport, curves, parts, own);
  const ponytail = new PonytailTool(host);
  const stops = [
    effect(() => {
      const evaluation = evaluator.result.value;
      const strands = evaluation?.strands ?? null;
      if (strands && evaluation?.step.type === 'hair') {
        const grown = Math.max(1, strandCount(strands));
        hair.setHairOptions({ widthScale: Math.max(1, evaluation.step.strands.count / grown) });
      }
      hair.setHair(strands);
    }),
    // Colours on the scalp are of no use under a full head of hair.
    effect(() => {
      const strands = state.tool.value === 'paint-length' ? evaluator.result.value?.strands : null;
      const share = strands ? Math.min(1, SPARSE / Math.max(1, strandCount(strands))) : own.share.value;
      hair.setStrandShare(share);
    }),
    frameHair({ viewport, state, evaluator }, sight),
    effect(() => {
      hair.setHairOptions({ show: own.show.value.hair, shading: own.shading.value });
    }),
    effect(() => {
      const step = own.step.value;
      const stroke = own.stroke.value;
      const shown = step && own.show.value.curves ? curvesOf(step, state.selection.value.item) : [];
      const drawn =
        stroke && stroke.line.length > 1
          ? [{ id: 'stroke', points: stroke.line, ...CURVE_LOOKS[stroke.kind], selected: false }]
          : [];
      curves.setLines([...shown, ...drawn]);
    }),
    effect(() => {
      const surface = host.surface.value;
      support.setSupport(surface && own.show.value.support && isEditing(parts, own) ? surface : null);
    }),
    effect(() => {
      const evaluation = evaluator.result.value;
      const step = own.step.value;
      const painted = host.paint.value;
      const tool = state.tool.value;
      if (evaluation?.step.type !== 'hair' || !step) return;
      const vertices = painted ?? scalpOf(step, evaluation.shown.model);
      const shown = tool === 'paint-scalp' || tool === 'paint-length';
      viewport.setRegions(
        shown ? [{ id: 'scalp', tint: 'green', vertices, visible: true, selected: true }] : [],
      );
    }),
    effect(() => {
      const values = shownLengths(state, own, evaluator.result.value);
      viewport.setHeat(values && { values, range: LENGTHS });
    }),
    syncField(layers.ports, parts, own),
  ];
  return {
    tools: {
      'hair-select': new HairSelectTool(host),
      stream: new StreamTool(host),
      hint: new HintTool(host),
      parting: new PartingTool(host),
      ponytail,
      'paint-scalp': paintScalp(host),
      'paint-length': paintLength(new AppLengthHost(host, parts, own)),
    },
    back: () => state.tool.peek() === 'ponytail' && ponytail.back(),
    unmount: () => {
      for (const stop of stops) stop();
      layers.unmount();
      viewport.setRegions([]);
      viewport.setHeat(null);
      // What a file shows meanwhile is framed for itself.
      if (state.viewing.peek()) sight.surface = null;
    },
  };
}

/** Whether strokes land on the supporting surface now. */
function isEditing({ state }: Pick<Parts, 'state'>, own: HairState): boolean {
  if (state.tool.value === 'hint') return true;
  const step = own.step.value;
  const selected = state.selection.value.item;
  return (
    state.tool.value === 'ponytail' && step !== undefined && ponytailStage({ step, selected }) !== 'spine'
  );
}
