// The line in hand: picked from the drawing, trimmed, pulled. A pull on a surface that curves bend already is a step of
// its own on top of it, so that every pull starts from what is seen.

import { freeId, putStep } from '../../../recipe/edit';
import type { Recipe } from '../../../recipe/recipe';
import { type CurvesStep, newCurvesStep } from '../../../recipe/steps/curves';
import { addCurve, curveById, freeCurveId, pointsOf, updateCurve } from '../../../recipe/steps/curves-edits';
import {
  curveOf,
  type PickedLine,
  partOf,
  pickedFrom,
  pickedOf,
} from '../../../tools/curves/contours/picked';
import { kept } from '../../../tools/curves/edits';
import { splinePoints } from '../../../tools/curves/spline';
import { add, subtract } from '../../../tools/geometry';
import type { Line } from '../../../tools/stroke/polyline';
import type { PenHit } from '../../../view/overlays/types';
import type { Vec3 } from '../../../view/types';
import { t } from '../../i18n';
import type { WingParts } from '../../wing-parts';
import type { CurvesEdits } from '../edits';
import { extentShown } from '../extent';
import type { CurvesState } from '../state';
import type { InHand } from './state';

/** How far a pull goes unless it is told otherwise, in shares of the model's largest extent: as the kernel has it. */
const REACH = 0.13;

export class Hand {
  /** As it was before it was adjusted. */
  #before: InHand | null = null;
  /** Of the next line, in shares of the extent. */
  #reach = REACH;

  constructor(
    private readonly parts: Pick<WingParts, 'state' | 'document' | 'evaluator'>,
    private readonly own: CurvesState,
    private readonly edits: CurvesEdits,
  ) {}

  /** The model's largest extent. */
  get size(): number {
    return extentShown(this.parts.evaluator);
  }

  get #held(): InHand | null {
    return this.own.contours.hand.peek();
  }

  pickUp(hit: PenHit): void {
    const { contours } = this.own;
    const evaluation = this.parts.evaluator.result.peek();
    const { step } = this.edits;
    const drawing = contours.lines.peek();
    if (!step || !drawing || !evaluation?.settled || evaluation.step !== step) return;
    const { size } = this;
    const picked = pickedFrom(drawing, hit, this.#reach * size, size);
    const onto =
      step.curves.length === 0 ? step : newCurvesStep(freeId('curves', this.parts.document.recipe), step.id);
    const curve = freeCurveId(onto, t('curves.line'));
    const made = curveOf(picked, curve, contours.beside.peek(), size);
    contours.hand.value = { picked, step: addCurve(onto, made), curve, base: step };
  }

  /** @returns whether there was a line in hand */
  letGo(): boolean {
    if (!this.#held) return false;
    this.own.contours.hand.value = null;
    this.parts.document.select(null);
    return true;
  }

  /** The document, and in it the line in hand at rest or as it was pulled. Reads no signals. */
  recipe(): Recipe | null {
    const held = this.#held;
    return held && putStep(this.parts.document.recipe, held.step);
  }

  trim(span: PickedLine['span']): void {
    this.#adjust({ span });
  }

  reach(radius: number): void {
    this.#reach = radius / this.size;
    this.#adjust({ reach: radius });
  }

  /** Makes the curve anew after it was adjusted, or after other lines are to stay or not. */
  settle(label: 'trim' | 'pull-reach' | 'beside'): void {
    const { contours } = this.own;
    const held = this.#held;
    this.#before = null;
    contours.adjusting.value = false;
    const old = held && curveById(held.step, held.curve);
    if (!held || !old) return;
    const isKept = contours.isKept.peek();
    const fresh = curveOf(held.picked, held.curve, contours.beside.peek(), this.size);
    const shift = shiftOf(held);
    const posed = old.posed && this.#shifted(fresh.rest, shift);
    const step = updateCurve(held.step, held.curve, { ...fresh, held: fresh.held, posed });
    contours.hand.value = { ...held, step };
    if (isKept)
      this.edits.commit(t(`history.curves.${label}`, { name: held.curve }), step, this.#grip(step, held));
  }

  /** Shows the line pulled from where it was. */
  pull(by: Vec3): void {
    const held = this.#held;
    const curve = held && curveById(held.step, held.curve);
    if (!held || !curve) return;
    const step = updateCurve(held.step, held.curve, { posed: this.#shifted(pointsOf(curve), by) });
    this.edits.preview(t('history.curves.pull', { name: held.curve }), step, this.#grip(step, held));
  }

  release(): void {
    this.edits.finish();
  }

  cancel(): void {
    if (this.#before) this.own.contours.hand.value = this.#before;
    this.#before = null;
    this.own.contours.adjusting.value = false;
    this.edits.cancel();
  }

  /** What is in hand once the document has changed, or another curve was selected. */
  after(step: CurvesStep | undefined): InHand | null {
    const { contours, grip } = this.own;
    const held = this.#held;
    if (!contours.on.peek()) return null;
    if (held && step) {
      const curve = step.id === held.step.id ? curveById(step, held.curve) : undefined;
      if (curve) {
        if (step === held.step) return held;
        const known = curveById(held.step, held.curve);
        const isSame = curve.rest === known?.rest && curve.reach === known.reach;
        return { ...held, step, picked: isSame ? held.picked : pickedOf(curve, REACH * this.size) };
      }
      // Not yet, or no longer, in the document: at rest again.
      if (step === held.base)
        return { ...held, step: updateCurve(held.step, held.curve, { posed: undefined }) };
    }
    const at = grip.peek();
    const curve = at && step?.curves[at.curve];
    if (curve?.kind !== 'contour' || !step) return null;
    return { picked: pickedOf(curve, REACH * this.size), step, curve: curve.id, base: step };
  }

  /** Where the line in hand is now. Reads signals. */
  line(): Line | null {
    const { contours, step } = this.own;
    const held = contours.hand.value;
    if (!held) return null;
    if (contours.adjusting.value) {
      const shift = shiftOf(held);
      return partOf(held.picked.line, held.picked.span).map((point) => add(point, shift));
    }
    const shown = step.value?.id === held.step.id ? curveById(step.value, held.curve) : undefined;
    const curve = shown ?? curveById(held.step, held.curve);
    return curve ? splinePoints(pointsOf(curve)) : null;
  }

  #adjust(change: Partial<Pick<PickedLine, 'span' | 'reach'>>): void {
    const held = this.#held;
    if (!held) return;
    this.#before ??= held;
    this.own.contours.adjusting.value = true;
    this.own.contours.hand.value = { ...held, picked: { ...held.picked, ...change } };
  }

  #shifted(points: readonly Vec3[], by: Vec3) {
    const { size } = this;
    return points.map((point) => kept(add(point, by), size));
  }

  #grip(step: CurvesStep, { curve }: InHand) {
    return { curve: step.curves.findIndex(({ id }) => id === curve), point: null };
  }
}

/** How far the line in hand has been pulled: all of it alike, as far as pulls go. */
export function shiftOf({ step, curve }: InHand): Vec3 {
  const held = curveById(step, curve);
  const middle = held ? Math.floor(held.rest.length / 2) : 0;
  return held?.posed ? subtract(held.posed[middle]!, held.rest[middle]!) : [0, 0, 0];
}
