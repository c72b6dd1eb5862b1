// The app's side of the merge tools, one for each of the two panes.

import type { MergeStep } from '../../recipe/recipe';
import type { Brush, Paint } from '../../tools/brush-stroke';
import type { Mark, MergeEditLabel, MergeHost, MergeScene } from '../../tools/merge/host';
import type { Loop } from '../../tools/merge/loops';
import type { MergeBoundary, MergeSide } from '../../tools/merge/pins';
import { verticesThrough } from '../../tools/merge/through';
import type { PaintVerb } from '../../tools/paint-tool';
import type { Hit, ViewportPort } from '../../view/types';
import { t } from '../i18n';
import { brushOf } from '../surface-aids';
import type { WingParts } from '../wing-parts';
import type { MergeActions } from './actions';
import type { MergeState } from './state';
import { markOf } from './steps';

interface Parts extends Pick<WingParts, 'state' | 'document'> {
  readonly own: MergeState;
  readonly actions: MergeActions;
}

export class AppMergeHost implements MergeHost {
  constructor(
    readonly side: MergeSide,
    readonly view: ViewportPort,
    private readonly parts: Parts,
  ) {}

  scene(): MergeScene | null {
    const { document, state, own, actions } = this.parts;
    const { step } = actions.edits;
    const aids = { source: actions.aids.of('source'), target: actions.aids.of('target') };
    const mine = aids[this.side];
    if (!step || state.choosing.peek() || !aids.source || !aids.target || !mine) return null;
    return {
      step,
      positions: { source: aids.source.positions, target: aids.target.positions },
      loops: mine.loops,
      pins: actions.joins.pins(),
      boundaries: actions.joins.boundaries(),
      selected: document.selection.item,
      mark: (mark) => markOf(step, mark, mine.positions.length / 3),
      graph: mine.graph,
      mirrored: (vertices) => vertices,
      ...(own.through.peek() && {
        under: (hit: Hit, radius: number) => verticesThrough(mine.positions, hit, radius, this.view.camera),
      }),
    };
  }

  brush(): Brush {
    return brushOf(this.parts.state);
  }

  commitMark(mark: Mark, verb: PaintVerb, vertices: Uint32Array): void {
    this.parts.actions.marking.setMark(mark, vertices, t(`history.merge.${verb}-${mark}`));
  }

  showPaint(paint: Paint | null): void {
    this.parts.own.paint.value = paint && { mark: paint.kind as Mark, vertices: paint.vertices };
  }

  preview(boundaries: readonly MergeBoundary[], selected: number | null): void {
    this.parts.actions.joins.previewBoundaries(writable(boundaries), selected);
  }

  commit(label: MergeEditLabel, boundaries: readonly MergeBoundary[], selected: number | null): void {
    this.parts.actions.joins.setBoundaries(t(`history.merge.${label}`), writable(boundaries), selected);
  }

  cancel(): void {
    this.parts.document.cancel();
  }

  select(pin: number | null): void {
    this.parts.document.select(pin);
  }

  hoverLoop(loop: Loop | null): void {
    const { hovered } = this.parts.own;
    if ((hovered.peek()?.loop ?? null) !== loop) hovered.value = loop && { side: this.side, loop };
  }

  pickLoop(loop: Loop): void {
    this.parts.actions.joins.pickLoop(this.side, loop);
  }
}

const writable = (boundaries: readonly MergeBoundary[]): MergeStep['boundaries'] => [...boundaries];
