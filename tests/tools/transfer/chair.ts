// Whom the pairing tools serve, on the flat sheet that the other tools are tried on.

import { fromIndices, toIndices } from '../../../web/core/vertex-set';
import type { DeformHandle, TransferStep } from '../../../web/recipe/recipe';
import { newTransferStep } from '../../../web/recipe/steps/transfer';
import type { Paint } from '../../../web/tools/brush-stroke';
import type { PaintVerb } from '../../../web/tools/paint-tool';
import { setCounterpart } from '../../../web/tools/transfer/edits';
import type { TransferHost, TransferScene } from '../../../web/tools/transfer/host';
import { SIDE, Table } from '../table';

export const COUNT = SIDE * SIDE;
const MATRIX = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

export const region = (...vertices: number[]): DeformHandle => ({ kind: 'region', vertices, matrix: MATRIX });
export const point = (vertex: number): DeformHandle => ({
  kind: 'point',
  vertices: [vertex],
  position: [0, 0, 0],
});

export class Chair implements TransferHost {
  readonly table = new Table();
  readonly view = this.table.view;
  readonly brush = this.table.brush;
  step: TransferStep;
  selected: number | null = null;
  painted: Paint | null = null;
  readonly commits: (readonly [PaintVerb, number])[] = [];
  readonly picks: number[] = [];

  constructor(readonly handles: readonly DeformHandle[]) {
    this.step = newTransferStep('transfer 1', 'sheet', 'deform 1', handles.length);
  }

  scene(): TransferScene {
    const { step, handles, selected } = this;
    return { step, handles, selected, count: COUNT, graph: this.table.graph, mirrored: (set) => set };
  }

  showPaint(paint: Paint | null): void {
    this.painted = paint;
  }

  commit(verb: PaintVerb, handle: number, vertices: Uint32Array): void {
    this.commits.push([verb, handle]);
    this.step = setCounterpart(this.step, handle, vertices, COUNT);
  }

  pick(handle: number): void {
    this.picks.push(handle);
    this.selected = handle;
  }

  has(handle: number): number[] {
    return [...toIndices(this.step.handles[handle]!, COUNT)];
  }

  give(handle: number, ...vertices: number[]): void {
    this.step = setCounterpart(this.step, handle, toIndices(fromIndices(vertices, COUNT), COUNT), COUNT);
  }
}
