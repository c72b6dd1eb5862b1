// What the workspace shows beside the shape: regions, what linked curves take over, where the surface meets itself.

import type { ReportOf } from '../../run/results';
import { IDENTITY, type Mat4 } from '../../tools/geometry';
import type { Evaluation } from '../evaluated';
import { NewestWork } from '../newest-work';
import type { WingParts } from '../wing-parts';
import type { CurvesFigures, CurvesState } from './state';

export class Follow {
  readonly #work: NewestWork;
  #shown: Evaluation | null = null;

  constructor(
    private readonly own: CurvesState,
    private readonly parts: Pick<WingParts, 'runner' | 'messages'>,
  ) {
    this.#work = new NewestWork(parts.messages);
  }

  publish(shown: Evaluation | null): void {
    this.#shown = shown;
    this.#work.end();
    const { own } = this;
    if (!shown?.report) {
      own.parents.value = [];
      own.prepared.value = null;
      own.figures.value = null;
      own.crossing.value = null;
      return;
    }
    const figures = figuresOf(shown);
    // While a drag lasts nothing is counted: the last count stays until the next.
    own.figures.value = figures && {
      ...figures,
      crossings: figures.crossings ?? own.figures.peek()?.crossings ?? null,
    };
    this.#work.start((signal) => this.#follow(shown, signal));
  }

  /** Shows where the surface goes through itself, or no longer. */
  toggleCrossings(): void {
    this.own.showCrossings.value = !this.own.showCrossings.peek();
    this.publish(this.#shown);
  }

  async #follow({ recipe, step, settled, positions, shown }: Evaluation, signal: AbortSignal): Promise<void> {
    if (step.type !== 'curves') return;
    const { runner } = this.parts;
    const { own } = this;
    if (step.links.length === 0) own.parents.value = [];
    else {
      const { matrices } = await runner.ask(recipe, step.id, 'curveParents', {}, { signal });
      own.parents.value = Array.from(
        step.curves,
        (_, i): Mat4 =>
          (16 * i < matrices.length ? [...matrices.subarray(16 * i, 16 * i + 16)] : IDENTITY) as Mat4,
      );
    }
    if (!settled) return;
    own.prepared.value = await runner.ask(recipe, step.id, 'preparedCurves', {}, { signal });
    if (!own.showCrossings.peek()) {
      own.crossing.value = null;
      return;
    }
    const { faces } = await runner.ask(recipe, step.id, 'crossingFaces', { positions }, { signal });
    const { faceOffsets, faceVertices } = shown.model;
    const met = new Set<number>();
    for (const face of faces)
      for (let i = faceOffsets[face]!; i < faceOffsets[face + 1]!; i++) met.add(faceVertices[i]!);
    own.crossing.value = Uint32Array.from(met).sort();
  }
}

function figuresOf({ report }: Evaluation): CurvesFigures | null {
  if (report?.type !== 'curves') return null;
  const { seconds, selfIntersections } = report as ReportOf<'curves'>;
  const { regions = 0, encode = 0, pose = 0 } = seconds;
  return { prepare: 1000 * (regions + encode), pose: 1000 * pose, crossings: selfIntersections ?? null };
}
