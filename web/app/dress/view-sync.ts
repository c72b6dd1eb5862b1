// The dress workspace on screen: the garment on the body it was made for in a pane, on the other body in the main viewport.

import { effect } from '@preact/signals';
import { clearances } from '../../tools/dress/clearance';
import { COMPANIONS } from '../../view/overlays/companions';
import type { Companion } from '../../view/overlays/types';
import type { ViewportPort } from '../../view/types';
import type { Evaluation } from '../evaluated';
import { paneModel } from '../panes';
import type { Mounted } from '../wing';
import type { WingParts } from '../wing-parts';
import type { Clearance, DressState } from './state';

type Parts = Pick<WingParts, 'state' | 'evaluator' | 'panes'>;

/** Of the distances, how many may lie beyond the end of the colours. */
const BEYOND = 0.02;

export function mountDress(viewport: ViewportPort, parts: Parts, own: DressState): Mounted {
  const { state, evaluator } = parts;
  const worn = viewport.mount(COMPANIONS);
  const shown = () => {
    const evaluation = evaluator.result.value;
    return !state.choosing.value && evaluation?.step.type === 'dress' ? evaluation : null;
  };
  const stops = [
    effect(() => {
      const evaluation = shown();
      own.clearance.value = evaluation?.report && own.heat.value ? clearanceOf(evaluation) : null;
    }),
    effect(() => worn.port.setCompanions(companionsOf(shown(), own))),
  ];
  const [pane] = parts.panes.take(1) ?? [];
  const stopPane = pane && mountSource(pane.viewport, parts, own);
  return {
    tools: {},
    unmount: () => {
      for (const stop of stops) stop();
      own.clearance.value = null;
      worn.unmount();
      stopPane?.();
    },
  };
}

/** What is worn over the body; the garment as it was, to be seen through it. */
function companionsOf(evaluation: Evaluation | null, own: DressState): Companion[] {
  if (!evaluation) return [];
  const { shown, positions, report } = evaluation;
  const { triangles } = shown.opened;
  const was: Companion = { id: 'was', positions: shown.model.positions, triangles, look: 'ghost' };
  // Until it is fitted it is where it was made, which is not on this body.
  if (!report) return [was];
  const heat = own.clearance.value ?? undefined;
  return [
    { id: 'worn', positions, triangles, look: 'cloth', heat },
    ...own.others.value.map(
      ({ id, ...other }, at): Companion => ({ ...other, id: `other ${id}`, look: 'cloth', dye: at + 1 }),
    ),
    ...(own.ghost.value ? [was] : []),
  ];
}

/** Colours about 0, where cloth touches. */
function clearanceOf({ positions, wearer }: Evaluation): Clearance | null {
  if (!wearer) return null;
  const values = clearances(positions, wearer.model.positions, wearer.opened.triangles);
  const sorted = values.map(Math.abs).sort();
  const end = sorted[Math.floor((1 - BEYOND) * (sorted.length - 1))] || 1;
  return { values, range: [-end, end] };
}

/** @returns the function that ends it */
function mountSource(viewport: ViewportPort, { state, evaluator }: Parts, own: DressState): () => void {
  const garment = viewport.mount(COMPANIONS);
  const show = paneModel(viewport);
  let framed: object | null = null;
  const stops = [
    effect(() => show(own.source.value)),
    effect(() => {
      const evaluation = evaluator.result.value;
      const isWorn = !state.choosing.value && evaluation?.step.type === 'dress';
      garment.port.setCompanions(
        isWorn
          ? [
              {
                id: 'garment',
                positions: evaluation.shown.model.positions,
                triangles: evaluation.shown.opened.triangles,
                look: 'cloth',
              },
            ]
          : [],
      );
    }),
    effect(() => viewport.setDisplay(state.display.value)),
    // A pane has its size only once it is on the page.
    viewport.onDraw(() => {
      const source = own.source.peek()?.opened ?? null;
      if (source === framed || viewport.size.width <= 1) return;
      framed = source;
      viewport.fit();
    }),
  ];
  return () => {
    for (const stop of stops) stop();
    garment.unmount();
    show(null);
  };
}
