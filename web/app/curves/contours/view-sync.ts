// The drawing on screen while its tool is in hand: paper and lines, the line in hand, what a pull would move.

import { effect, untracked } from '@preact/signals';
import { Latest } from '../../../core/latest';
import { curveById } from '../../../recipe/steps/curves-edits';
import { ContourTool } from '../../../tools/curves/contours/contour-tool';
import { middleOf } from '../../../tools/curves/contours/picked';
import type { Tool } from '../../../tools/tool';
import { PEN_LINES } from '../../../view/overlays/pen-lines';
import type { PointerSample, ViewportPort } from '../../../view/types';
import type { WingParts } from '../../wing-parts';
import type { CurvesState } from '../state';
import type { Hand } from './hand';
import { AppContoursHost } from './host';
import { ViewLines } from './view-lines';

type Parts = Pick<WingParts, 'state' | 'document' | 'evaluator' | 'runner' | 'messages'>;

export interface MountedContours {
  readonly tool: Tool;
  unmount(): void;
}

export function mountContours(
  viewport: ViewportPort,
  parts: Parts,
  own: CurvesState,
  hand: Hand,
): MountedContours {
  let shown: ReturnType<typeof show> | null = null;
  const stop = effect(() => {
    if (!own.contours.on.value) return;
    shown = untracked(() => show(viewport, parts, own, hand));
    return () => {
      shown?.end();
      shown = null;
    };
  });
  return {
    tool: {
      down: (sample) => shown?.tool.down(sample) ?? false,
      move: (samples) => shown?.tool.move(samples),
      up: (sample: PointerSample) => shown?.tool.up(sample),
      hover: (sample: PointerSample) => shown?.tool.hover(sample),
      leave: () => shown?.tool.leave(),
      cancel: () => shown?.tool.cancel(),
    },
    unmount: stop,
  };
}

function show(viewport: ViewportPort, parts: Parts, own: CurvesState, hand: Hand) {
  const { contours } = own;
  const { evaluator, state, runner, messages } = parts;
  const layer = viewport.mount(PEN_LINES);
  const pen = layer.port;
  const lines = new ViewLines(parts, contours, evaluator.result, () => viewport.camera);
  const host = new AppContoursHost(viewport, pen, contours, hand);
  const weights = new Latest<string, Float32Array | null>({
    work: async (_, signal) => {
      const held = contours.hand.peek();
      const recipe = hand.recipe();
      if (!held || !recipe) return null;
      const curve = held.step.curves.findIndex(({ id }) => id === held.curve);
      return runner.ask(recipe, held.step.id, 'pullWeights', { curve }, { signal });
    },
    deliver: (found) => {
      contours.weights.value = contours.hand.peek() && found;
    },
    fail: (error) => messages.failed(error),
  });
  let asked: unknown;
  const stops = [
    viewport.onDraw(() => lines.look()),
    // What is asked of the view, and of which surface.
    effect(() => {
      void [contours.detail.value, contours.smoothing.value, contours.suggestive.value];
      void [evaluator.result.value, state.previewing.value, contours.problem.value];
      untracked(() => lines.renew());
    }),
    effect(() => {
      pen.setDrawing(contours.lines.value);
      // Numbers of lines are others now.
      const { part } = contours.lit.peek();
      contours.lit.value = { line: null, part };
    }),
    effect(() => {
      const positions = evaluator.result.value?.positions;
      if (contours.lines.value) pen.carry(!positions || positions === lines.drawnOn ? null : positions);
    }),
    effect(() => pen.light(contours.lit.value.line)),
    effect(() => {
      const line = hand.line();
      const reach = contours.hand.value?.picked.reach ?? 0;
      const { part } = contours.lit.value;
      pen.hold(line && { line, ring: { centre: middleOf(line), radius: reach }, lit: part });
    }),
    effect(() => {
      const step = own.step.value;
      void own.grip.value;
      if (state.previewing.value) return;
      untracked(() => {
        contours.hand.value = hand.after(step);
      });
    }),
    effect(() => {
      const held = contours.hand.value;
      if (contours.adjusting.value) return;
      const curve = held && curveById(held.step, held.curve);
      if (!curve) {
        asked = null;
        weights.cancel();
        contours.weights.value = null;
      } else if (asked !== curve.rest) {
        asked = curve.rest;
        weights.push(held.curve);
      }
    }),
    effect(() => pen.tint(contours.weights.value)),
  ];
  return {
    tool: new ContourTool(host),
    end: () => {
      for (const stop of stops) stop();
      weights.cancel();
      lines.dispose();
      layer.unmount();
      contours.hand.value = null;
      contours.weights.value = null;
      contours.lines.value = null;
      contours.problem.value = null;
      contours.adjusting.value = false;
      contours.lit.value = { line: null, part: null };
    },
  };
}
