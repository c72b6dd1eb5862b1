// What panels and commands ask of the open curves step; each edit is one step of undo, except previews.

import { isCancelled, LissomError } from '../../core/errors';
import type { Curve, CurvesStep } from '../../recipe/steps/curves';
import type { CurvePose } from '../../recipe/steps/curves-edits';
import * as edits from '../../recipe/steps/curves-edits';
import * as poses from '../../recipe/steps/curves-poses';
import * as tools from '../../tools/curves/edits';
import type { Grip } from '../../tools/curves/items';
import { t, tCode } from '../i18n';
import type { WingParts } from '../wing-parts';
import { Hand } from './contours/hand';
import { CurvesEdits } from './edits';
import { extentShown } from './extent';
import { pointsOf } from './host';
import { Player } from './player';
import { pictureKey } from './pose-pictures';
import type { CurvesState } from './state';

/** What an end moves by at a click, in parts of the curve. */
const END_STEP = 0.1;

export class CurvesActions {
  readonly edits: CurvesEdits;
  readonly player: Player;
  /** The line of the drawing that is in hand. */
  readonly hand: Hand;

  constructor(
    private readonly parts: WingParts,
    private readonly own: CurvesState,
  ) {
    this.edits = new CurvesEdits(parts.document);
    this.player = new Player(this.edits, own);
    this.hand = new Hand(parts, own, this.edits);
  }

  /** The selected curve as shown. Reads signals. */
  curve(): Curve | undefined {
    const grip = this.own.grip.value;
    return grip ? this.own.step.value?.curves[grip.curve] : undefined;
  }

  rename(id: string, name: string): void {
    this.#edit('rename', id, (step) => edits.renameCurve(step, id, name.slice(0, 64)));
  }

  remove(id: string): void {
    this.#edit('remove', id, (step) => edits.removeCurve(step, id), null);
  }

  hide(id: string, hidden: boolean): void {
    const next = new Set(this.own.hidden.peek());
    if (hidden) next.add(id);
    else next.delete(id);
    this.own.hidden.value = next;
  }

  setKind(id: string, kind: Curve['kind']): void {
    this.#edit('kind', id, (step) => edits.updateCurve(step, id, { kind }));
  }

  setAnchor(id: string, anchor: Curve['anchor']): void {
    this.#edit('anchor', id, (step) => edits.updateCurve(step, id, { anchor }));
  }

  toggleRigid(id: string, segment: number): void {
    this.#edit('rigid', id, (step) => edits.toggleRigid(step, id, segment));
  }

  reset(id?: string): void {
    this.#edit(id === undefined ? 'reset-all' : 'reset', id ?? '', (step) => edits.resetCurves(step, id));
  }

  /** An end of the selected curve, one step inwards or outwards. */
  moveEnd(end: 'start' | 'end', inwards: boolean): void {
    const grip = this.own.grip.peek();
    const curve = this.curve();
    if (!grip || !curve) return;
    const by = inwards ? END_STEP : -END_STEP;
    this.#edit('end', curve.id, (step) => tools.moveEnd(step, grip.curve, end, by, this.#size));
  }

  mirror(): void {
    const grip = this.own.grip.peek();
    const { step } = this.edits;
    const curve = grip && step?.curves[grip.curve];
    if (!step || !curve) return;
    const mirrored = tools.mirrorCurve(step, grip.curve, t('curves.name'));
    this.edits.commit(t('history.curves.mirror', { name: curve.id }), mirrored, {
      curve: step.curves.length,
      point: null,
    });
  }

  unlink(id: string): void {
    this.#edit('unlink', id, (step) => edits.unlinkCurve(step, id));
  }

  setTwist(grip: Grip, degrees: number): void {
    this.#preview('twist', grip, (step) => tools.setTwist(step, grip, degrees, this.own.range.peek()));
  }

  setScale(grip: Grip, factors: [number, number]): void {
    this.#preview('scale', grip, (step) => tools.setScale(step, grip, factors, this.own.range.peek()));
  }

  setPoint(grip: Grip, to: readonly [number, number, number]): void {
    this.#preview('move', grip, (step) => tools.movePoint(step, grip, to, this.#size));
  }

  setOptions(options: Partial<CurvesStep['options']>): void {
    this.#edit('options', '', (step) => ({ ...step, options: { ...step.options, ...options } }));
  }

  /** Curves to begin with, found in the model itself; they join those that are there. */
  async propose(): Promise<void> {
    const { document, runner, messages, state } = this.parts;
    const { step } = this.edits;
    if (!step) return;
    try {
      const proposed = await runner.ask(document.recipe, step.id, 'proposedCurves', {});
      if (this.edits.step !== step) return;
      const size = this.#size;
      const first = step.curves.length;
      const curves = proposed.curves.reduce((held, { points }) => {
        const rest = pointsOf(points).map((point) => tools.kept(point, size));
        const id = edits.freeCurveId(held, t('curves.name'));
        return edits.addCurve(held, { id, kind: 'skeleton', rest });
      }, step);
      const idOf = (number: number): string => curves.curves[first + number]!.id;
      const linked = proposed.links.reduce(
        (held, { child, parent, at }) =>
          edits.linkCurves(held, { child: idOf(child), parent: idOf(parent), at }),
        curves,
      );
      this.edits.commit(t('history.curves.propose'), linked, null);
      state.tool.value = 'pose-curves';
    } catch (error) {
      if (isCancelled(error)) return;
      if (!(error instanceof LissomError) || error.fault !== 'input') throw error;
      messages.toast('info', tCode('curves.sketch.', error.code, 'curves.sketch.other'));
    }
  }

  addPose(): void {
    const { step } = this.edits;
    if (!step) return;
    const name = poses.freePoseName(step, t('curves.pose.name'));
    this.edits.commit(t('history.curves.add-pose', { name }), poses.addPose(step, name));
  }

  takePose(at: number): void {
    const { step } = this.edits;
    const pose = step?.poses[at];
    if (pose)
      this.edits.commit(t('history.curves.take-pose', { name: pose.name }), poses.takePose(step, pose));
  }

  renamePose(at: number, name: string): void {
    const { step } = this.edits;
    const trimmed = name.trim().slice(0, 64);
    if (step && trimmed)
      this.edits.commit(
        t('history.curves.rename-pose', { name: trimmed }),
        poses.renamePose(step, at, trimmed),
      );
  }

  removePose(at: number): void {
    const { step } = this.edits;
    const pose = step?.poses[at];
    if (pose)
      this.edits.commit(t('history.curves.remove-pose', { name: pose.name }), poses.removePose(step, at));
  }

  /** The address of a pose's picture, once it is made. Reads signals. */
  picture(pose: CurvePose): string | undefined {
    const step = this.own.step.value;
    return step && this.own.posePictures.value.get(pictureKey(step, pose));
  }

  /** What lies between two poses, while a slider moves; then `edits.finish`. */
  blend(from: number, to: number, t01: number): void {
    const { step } = this.edits;
    const [a, b] = [step?.poses[from], step?.poses[to]];
    if (step && a && b) this.edits.preview(t('history.curves.blend'), poses.betweenPoses(step, a, b, t01));
  }

  get #size(): number {
    return extentShown(this.parts.evaluator) || 1;
  }

  #edit(label: EditName, name: string, change: (step: CurvesStep) => CurvesStep, grip?: Grip | null): void {
    const { step } = this.edits;
    if (step) this.edits.commit(t(`history.curves.${label}`, { name }), change(step), grip);
  }

  #preview(label: 'move' | 'twist' | 'scale', grip: Grip, change: (step: CurvesStep) => CurvesStep): void {
    const { step } = this.edits;
    if (!step) return;
    const name = step.curves[grip.curve]?.id ?? '';
    this.edits.preview(t(`history.curves.${label}`, { name }), change(step));
  }
}

type EditName =
  | 'rename'
  | 'remove'
  | 'kind'
  | 'anchor'
  | 'rigid'
  | 'reset'
  | 'reset-all'
  | 'end'
  | 'unlink'
  | 'options';
