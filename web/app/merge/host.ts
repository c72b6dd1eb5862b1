// The app's side of the merge tools, one for each of the two panes.

import type { MergeStep } from '../../recipe/recipe';
import type { Brush, Paint } from '../../tools/brush-stroke';
import type { Mark, MergeEditLabel, MergeHost, MergeScene } from '../../tools/merge/host';
import type { Loop } from '../../tools/merge/loops';
import type { MergeBoundary, MergeSide } from '../../tools/merge/pins';
import { verticesThrough } from '../../tools/merge/through';
import type { PaintVerb } from '../../tools/paint-tool';
import type { Hit, ViewportPort } from '../../view/types';
import type { Document } from '../document';
import { t } from '../i18n';
import type { State } from '../state';
import type { MergeActions } from './actions';
import { markOf, mergeStepById } from './steps';

interface Parts {
  readonly state: State;
  readonly document: Document;
  readonly actions: MergeActions;
}

export class AppMergeHost implements MergeHost {
  constructor(
    readonly side: MergeSide,
    readonly view: ViewportPort,
    private readonly parts: Parts,
  ) {}

  scene(): MergeScene | null {
    const { document, state, actions } = this.parts;
    const step = mergeStepById(document.recipe, document.selection.step);
    const aids = { source: actions.aids.of('source'), target: actions.aids.of('target') };
    const own = aids[this.side];
    if (!step || state.choosing.peek() || !aids.source || !aids.target || !own) return null;
    return {
      step,
      positions: { source: aids.source.positions, target: aids.target.positions },
      loops: own.loops,
      pins: actions.pins(),
      boundaries: actions.boundaries(),
      selected: document.selection.handle,
      mark: (mark) => markOf(step, mark, own.positions.length / 3),
      graph: own.graph,
      mirrored: (vertices) => vertices,
      ...(state.merge.through.peek() && {
        under: (hit: Hit, radius: number) => verticesThrough(own.positions, hit, radius, this.view.camera),
      }),
    };
  }

  brush(): Brush {
    const { state } = this.parts;
    return { radius: state.brushSize.peek(), erase: state.brushMode.peek() === 'erase' };
  }

  commitMark(mark: Mark, verb: PaintVerb, vertices: Uint32Array): void {
    this.parts.actions.setMark(mark, vertices, t(`history.merge.${verb}-${mark}`));
  }

  showPaint(paint: Paint | null): void {
    this.parts.state.merge.paint.value = paint && { mark: paint.kind as Mark, vertices: paint.vertices };
  }

  preview(boundaries: readonly MergeBoundary[], selected: number | null): void {
    this.parts.actions.previewBoundaries(writable(boundaries), selected);
  }

  commit(label: MergeEditLabel, boundaries: readonly MergeBoundary[], selected: number | null): void {
    this.parts.actions.setBoundaries(t(`history.merge.${label}`), writable(boundaries), selected);
  }

  cancel(): void {
    this.parts.document.cancel();
  }

  select(pin: number | null): void {
    this.parts.document.select(pin);
  }

  hoverLoop(loop: Loop | null): void {
    const { hovered } = this.parts.state.merge;
    if ((hovered.peek()?.loop ?? null) !== loop) hovered.value = loop && { side: this.side, loop };
  }

  pickLoop(loop: Loop): void {
    this.parts.actions.pickLoop(this.side, loop);
  }
}

const writable = (boundaries: readonly MergeBoundary[]): MergeStep['boundaries'] => [...boundaries];
