// The lines of the view, found in the worker: one view at a time, and of those that wait only the newest.

import type { ReadonlySignal } from '@preact/signals';
import { LissomError } from '../../../core/errors';
import { Latest } from '../../../core/latest';
import type { ContourLines, ContourOptions, ContourView } from '../../../kernel/contract/contour';
import type { CameraState } from '../../../view/types';
import { busySign } from '../../busy-sign';
import type { Evaluation } from '../../evaluated';
import { t } from '../../i18n';
import type { WingParts } from '../../wing-parts';
import type { ContoursState } from './state';

/** The view has come to rest when it has not moved for so many ms. */
const CALM = 150;
/** A view that takes longer, in seconds, is drawn without its suggestive lines while it turns. */
const SLOW = 0.05;

interface Asked {
  readonly evaluation: Evaluation;
  readonly camera: CameraState;
  readonly sweeps: number;
  readonly options: ContourOptions;
}

export class ViewLines {
  readonly #runs: Latest<Asked, ContourLines>;
  #asked: Asked | null = null;
  /** What the kernel holds the curvature of. */
  #prepared: { readonly positions: Float64Array; readonly sweeps: number } | null = null;
  /** The last whole answer, and how long it took, in seconds. */
  #whole: ContourLines | null = null;
  #faces: Uint32Array | undefined;
  /** Where the surface was that the lines are on. */
  drawnOn: Float64Array | null = null;
  #slow = false;
  #calm: ReturnType<typeof setTimeout> | undefined;
  #over = false;

  constructor(
    private readonly parts: Pick<WingParts, 'state' | 'runner' | 'messages'>,
    private readonly own: ContoursState,
    private readonly result: ReadonlySignal<Evaluation | null>,
    private readonly camera: () => CameraState,
  ) {
    this.#runs = new Latest({
      work: (asked, signal) => this.#ask(asked, signal),
      deliver: (lines, asked) => this.#take(lines, asked),
      fail: (error) => {
        this.#asked = null;
        const isBare = error instanceof LissomError && error.code === 'no-faces';
        this.own.problem.value = isBare ? 'no-faces' : 'failed';
        if (!isBare) this.parts.messages.failed(error);
      },
    });
  }

  /** Asks for the lines of what is shown, if that is not what was asked last. Reads no signals. */
  look(): void {
    const evaluation = this.result.peek();
    const { own } = this;
    if (this.#over || own.problem.peek() || !evaluation || evaluation.step.type !== 'curves') return;
    // While the hand moves the surface the lines go along with it; what they have become is seen when it rests.
    if (this.parts.state.previewing.peek() || !evaluation.settled) return;
    if (evaluation.shown.opened.triangles.length === 0) {
      own.lines.value = null;
      own.problem.value = 'no-faces';
      return;
    }
    const camera = this.camera();
    const last = this.#asked;
    if (this.#slow && last && !sameView(last.camera, camera)) this.#whenCalm();
    const isTurning = this.#calm !== undefined;
    const asked: Asked = {
      evaluation,
      camera,
      sweeps: own.smoothing.peek(),
      options: this.#options(own.suggestive.peek() && !isTurning),
    };
    if (last && sameAsked(last, asked)) return;
    this.#asked = asked;
    this.#runs.push(asked);
  }

  /** Another result: of another model, what kept lines from being found says nothing. */
  renew(): void {
    const faces = this.result.peek()?.shown.model.faceVertices;
    if (faces !== this.#faces) {
      this.#faces = faces;
      this.own.problem.value = null;
      this.own.lines.value = null;
      this.#whole = null;
    }
    this.look();
  }

  dispose(): void {
    this.#over = true;
    clearTimeout(this.#calm);
    this.#runs.cancel();
  }

  #options(suggestive: boolean): ContourOptions {
    const few = 1 - this.own.detail.peek();
    return { suggestive, strength: 0.4 * few ** 2, shortest: 0.2 * few };
  }

  #whenCalm(): void {
    clearTimeout(this.#calm);
    this.#calm = setTimeout(() => {
      this.#calm = undefined;
      this.look();
    }, CALM);
  }

  async #ask({ evaluation, camera, sweeps, options }: Asked, signal: AbortSignal): Promise<ContourLines> {
    const { runner, state } = this.parts;
    const { recipe, step, positions } = evaluation;
    const ready = this.#prepared?.positions === positions && this.#prepared.sweeps === sweeps;
    const sign = ready ? null : busySign(state.busy, t('busy.contours'), () => this.#stop());
    try {
      const args = { positions, sweeps, view: viewOf(camera), options };
      const onProgress = (fraction: number) => sign?.progress(fraction);
      const lines = await runner.ask(recipe, step.id, 'viewLines', args, { signal, onProgress });
      this.#prepared = { positions, sweeps };
      return lines;
    } finally {
      sign?.end();
    }
  }

  #take(lines: ContourLines, { options, evaluation }: Asked): void {
    this.drawnOn = evaluation.positions;
    const wanted = this.own.suggestive.peek();
    if (options.suggestive || !wanted) {
      this.#slow = lines.seconds > SLOW;
      this.#whole = lines;
      this.own.lines.value = lines;
    } else this.own.lines.value = this.#whole ? withFine(lines, this.#whole) : lines;
    // What was asked for meanwhile is on its way; a view that moved since the last picture comes with the next.
    this.look();
  }

  /** By hand. */
  #stop(): void {
    this.#runs.cancel();
    this.#asked = null;
    this.own.problem.value = 'stopped';
  }
}

const viewOf = ({ position, target, orthographic }: CameraState): ContourView =>
  orthographic
    ? { perspective: false, eye: [position[0] - target[0], position[1] - target[1], position[2] - target[2]] }
    : { perspective: true, eye: position };

/** The eye decides: where a view in perspective looks to changes none of its lines. */
function sameView(a: CameraState, b: CameraState): boolean {
  const [p, q] = [viewOf(a), viewOf(b)];
  return p.perspective === q.perspective && p.eye.every((x, k) => x === q.eye[k]);
}

const sameAsked = (a: Asked, b: Asked): boolean =>
  a.evaluation.positions === b.evaluation.positions &&
  a.evaluation.step.id === b.evaluation.step.id &&
  a.sweeps === b.sweeps &&
  sameView(a.camera, b.camera) &&
  a.options.strength === b.options.strength &&
  a.options.shortest === b.options.shortest &&
  a.options.suggestive === b.options.suggestive;

/** The contours of one answer with the suggestive lines of another on the same surface. */
export function withFine(contours: ContourLines, whole: ContourLines): ContourLines {
  const fine = whole.suggestive.indexOf(1);
  if (fine < 0) return contours;
  const first = whole.offsets[fine]!;
  const count = contours.points.length / 3;
  const shifted = whole.offsets.slice(fine + 1).map((at) => at - first + count);
  return {
    ...contours,
    points: joined(contours.points, whole.points.subarray(3 * first)),
    corners: joined(contours.corners, whole.corners.subarray(3 * first)),
    weights: joined(contours.weights, whole.weights.subarray(3 * first)),
    offsets: joined(contours.offsets, shifted),
    suggestive: joined(contours.suggestive, whole.suggestive.subarray(fine)),
    closed: joined(contours.closed, whole.closed.subarray(fine)),
    strength: joined(contours.strength, whole.strength.subarray(fine)),
  };
}

function joined<A extends Float64Array | Float32Array | Uint32Array | Uint8Array>(a: A, b: A): A {
  const out = new (a.constructor as new (length: number) => A)(a.length + b.length);
  out.set(a);
  out.set(b, a.length);
  return out;
}
