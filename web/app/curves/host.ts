// The app's side of the curve tools: the scene they read, the edits they make.

import { isCancelled, LissomError } from '../../core/errors';
import type { SketchedCurve } from '../../kernel/contract/sketch';
import type { CurvesStep } from '../../recipe/recipe';
import { addDrawn, isOnPlane, mirrorCurve } from '../../tools/curves/edits';
import type {
  CurvesEdit,
  CurvesHost,
  CurvesLabel,
  CurvesRemark,
  CurvesScene,
  DrawnStroke,
} from '../../tools/curves/host';
import { type Grip, itemOf } from '../../tools/curves/items';
import { splinePoints } from '../../tools/curves/spline';
import type { Line } from '../../tools/stroke/polyline';
import type { ControlLinesPort } from '../../view/overlays/types';
import type { Vec3, ViewportPort } from '../../view/types';
import { t, tCode } from '../i18n';
import type { WingParts } from '../wing-parts';
import type { CurvesEdits } from './edits';
import { extentOf } from './extent';
import type { CurvesState } from './state';

type Parts = Pick<WingParts, 'state' | 'document' | 'evaluator' | 'runner' | 'messages'>;

/** A stroke that ends this near to a control point means it, in CSS pixels. */
const NEAR = 14;

export class AppCurvesHost implements CurvesHost {
  #foreseeing = false;
  #next: DrawnStroke | null = null;

  constructor(
    readonly view: ViewportPort,
    readonly lines: ControlLinesPort,
    private readonly parts: Parts,
    private readonly own: CurvesState,
    private readonly edits: CurvesEdits,
  ) {}

  scene(): CurvesScene | null {
    const { step } = this.edits;
    const evaluation = this.parts.evaluator.result.peek();
    if (!step || evaluation?.step.id !== step.id) return null;
    return {
      step,
      selected: this.own.grip.peek(),
      parents: this.own.parents.peek(),
      anchors: step.curves.map(
        ({ anchor }, i) => anchor ?? this.own.prepared.peek()?.curves[i]?.anchor ?? 'start',
      ),
      size: extentOf(evaluation.shown.model.positions),
    };
  }

  reaches(): boolean {
    return this.own.reach.peek();
  }

  slides(): boolean {
    return this.own.gizmo.peek() === 'end';
  }

  range(): number {
    return this.own.range.peek();
  }

  hover(grip: Grip | null): void {
    const { under } = this.own;
    const before = under.peek();
    if (grip?.curve !== before?.curve || grip?.point !== before?.point) under.value = grip;
  }

  preview({ step, selected }: CurvesEdit): void {
    this.edits.preview('', step, selected);
  }

  commit(label: CurvesLabel, { step, selected }: CurvesEdit): void {
    const name = step.curves[selected?.curve ?? -1]?.id ?? '';
    this.edits.commit(t(`history.curves.${label}`, { name }), step, selected);
  }

  cancel(): void {
    this.edits.cancel();
  }

  select(grip: Grip | null): void {
    this.parts.document.select(grip && itemOf(grip));
  }

  showStroke(line: Line | null): void {
    this.own.stroke.value = line;
    if (line) return;
    this.#next = null;
    this.own.foreseen.value = null;
    this.own.reached.value = null;
  }

  foresee(stroke: DrawnStroke): void {
    this.#next = stroke;
    if (!this.#foreseeing) void this.#foresee();
  }

  async draw(stroke: DrawnStroke): Promise<void> {
    const scene = this.scene();
    if (!scene) return;
    try {
      const { kind, points, radius, warnings } = await this.#sketched(stroke);
      // Undone or edited meanwhile: the stroke was meant for the step as it was.
      const { step } = this.edits;
      if (!step || step.id !== scene.step.id) return;
      const line = pointsOf(points);
      const still = NEAR * this.view.pixelSize(line[0]!);
      // Inside a joint the ends of strokes move by up to the limb's radius.
      const near = Math.max(still, radius[0] ?? 0, radius.at(-1) ?? 0);
      const { size } = scene;
      const drawn = addDrawn(step, kind, line, { name: t('curves.name'), near, size });
      const both =
        this.parts.state.mirror.peek() && !isOnPlane(line, still)
          ? mirrorCurve(drawn.step, drawn.curve, t('curves.name'))
          : drawn.step;
      this.commit('draw', { step: both, selected: { curve: drawn.curve, point: null } });
      const [warning] = warnings;
      if (warning)
        this.parts.messages.toast('info', tCode('curves.sketch.', warning.code, 'curves.sketch.other'));
    } catch (error) {
      if (isCancelled(error)) return;
      if (!(error instanceof LissomError) || error.fault !== 'input') throw error;
      this.parts.messages.toast('info', tCode('curves.sketch.', error.code, 'curves.sketch.other'));
    }
  }

  async share(from: CurvesStep, to: CurvesStep): Promise<number> {
    const { document, runner } = this.parts;
    const args = { to: to.curves };
    return (await runner.ask(document.recipe, from.id, 'curveDragLimit', args)).share;
  }

  showStopped(stopped: boolean): void {
    this.own.stopped.value = stopped;
  }

  async reach(points: readonly Vec3[], end: number, target: Vec3, held: readonly number[]): Promise<Vec3[]> {
    const { document, runner } = this.parts;
    const args = { points: Float64Array.from(points.flat()), end, target, held: Uint32Array.from(held) };
    return pointsOf((await runner.ask(document.recipe, document.selection.step, 'chainReach', args)).points);
  }

  failed(error: unknown): void {
    if (!isCancelled(error)) this.parts.messages.failed(error);
  }

  say(remark: CurvesRemark): void {
    this.parts.messages.toast('info', t(`curves.remark.${remark}`));
  }

  #sketched({ samples, rays }: DrawnStroke) {
    const { document, runner } = this.parts;
    return runner.ask(document.recipe, document.selection.step, 'sketchedCurve', {
      pixels: Float64Array.from(samples.flatMap(({ x, y }) => [x, y])),
      origins: Float64Array.from(rays.flatMap(({ origin }) => [...origin])),
      directions: Float64Array.from(rays.flatMap(({ direction }) => [...direction])),
      options: { kind: this.own.kind.peek() },
    });
  }

  async #reached({ points, radius, hits }: SketchedCurve): Promise<Uint32Array> {
    const { document, runner } = this.parts;
    const args = { points, options: { radius, hits } };
    return (await runner.ask(document.recipe, document.selection.step, 'strokeRegion', args)).vertices;
  }

  /** The newest stroke under way, one at a time; one that makes no curve yet shows none. */
  async #foresee(): Promise<void> {
    this.#foreseeing = true;
    while (this.#next) {
      const stroke = this.#next;
      this.#next = null;
      const found = await this.#sketched(stroke).catch(() => null);
      if (this.own.stroke.peek()) this.own.foreseen.value = found && splinePoints(pointsOf(found.points));
      const reached = found && (await this.#reached(found).catch(() => null));
      if (this.own.stroke.peek()) this.own.reached.value = reached;
    }
    this.#foreseeing = false;
  }
}

/** Points of three numbers each. */
export const pointsOf = (flat: Float64Array): Vec3[] =>
  Array.from({ length: flat.length / 3 }, (_, i) => [flat[3 * i]!, flat[3 * i + 1]!, flat[3 * i + 2]!]);
