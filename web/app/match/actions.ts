import type { MatchStep } from '../../recipe/recipe';
import { t } from '../i18n';
import type { WingParts } from '../wing-parts';
import { MatchEdits } from './edits';
import { lacking } from './evaluation';
import { Marking } from './marking';
import { MatchModels, type PosedBy } from './models';
import type { PoorPlace } from './result';
import type { MatchState, PaneLook } from './state';

/** Those of the step's fields that are set by controls. */
export type MatchSettings = Pick<
  MatchStep,
  'edgeLength' | 'adapt' | 'sharpAngle' | 'first' | 'genus' | 'method' | 'together' | 'start'
>;

/** What panels, commands and tools ask of the open match step. Each edit is one step of undo, except previews. */
export class MatchActions {
  readonly edits: MatchEdits;
  readonly models: MatchModels;
  readonly marking: Marking;

  constructor(
    private readonly parts: WingParts,
    private readonly own: MatchState,
  ) {
    this.edits = new MatchEdits(parts.document, own);
    this.models = new MatchModels(this.edits, own, parts);
    this.marking = new Marking(this.edits, own, parts);
  }

  /** Whether there is something that the button would do. Reads signals. */
  canRun(): boolean {
    const step = this.own.step.value;
    if (!step || this.own.running.value || lacking(step) > 0) return false;
    return this.own.result.value?.of !== step;
  }

  /** Matches the models as they are marked now. */
  run(): void {
    const { step } = this.edits;
    if (!step) return;
    this.own.problem.value = null;
    this.own.poor.value = null;
    this.own.ask(step);
  }

  /** @param change  a field that is `undefined` is left out */
  set(change: { readonly [K in keyof MatchSettings]?: MatchSettings[K] | undefined }, live = false): void {
    const { step } = this.edits;
    if (!step) return;
    const next = Object.fromEntries(
      Object.entries({ ...step, ...change }).filter(([, value]) => value !== undefined),
    ) as MatchStep;
    const label = t('history.match.settings');
    if (live) this.edits.preview(label, next);
    else this.edits.commit(label, next);
  }

  /** Leads to where a model is posed before it is matched. */
  pose(model: number, by: PosedBy): void {
    this.models.pose(model, by).catch((error: unknown) => this.parts.messages.failed(error));
  }

  look(model: number, look: PaneLook): void {
    const name = this.own.step.peek()?.models[model];
    if (name !== undefined) this.own.looks.value = { ...this.own.looks.peek(), [name]: look };
  }

  lookAll(look: PaneLook): void {
    const names = this.own.step.peek()?.models ?? [];
    this.own.looks.value = Object.fromEntries(names.map((name) => [name, look]));
  }

  /** Takes up a marker or a curve. */
  pick(item: number): void {
    this.own.poor.value = null;
    this.parts.document.select(item);
  }

  /** Brings a poor place before the eyes and the marker tool into the hand. */
  showPoor({ vertex }: PoorPlace): void {
    const { state, document } = this.parts;
    document.select(null);
    state.tool.value = 'match-marker';
    this.own.poor.value = vertex;
  }
}
