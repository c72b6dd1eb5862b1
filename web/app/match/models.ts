// Which models are matched, and in what order. One that is asked for has done nothing to the recipe until it is chosen.

import { LissomError } from '../../core/errors';
import { crossCheck } from '../../recipe/cross-checks';
import * as edit from '../../recipe/edit';
import { type MatchStep, type ModelRef, type Recipe, stepRow } from '../../recipe/recipe';
import { producedNames } from '../../recipe/references';
import { MAX_MATCHED, newMatchStep } from '../../recipe/steps/match';
import { withModels } from '../../tools/match/edits';
import { t } from '../i18n';
import type { WingParts } from '../wing-parts';
import type { MatchEdits } from './edits';
import type { MatchState } from './state';

/** What is asked for: the first partner of a model, one more, or one in the place of another. */
type Asking =
  | { readonly kind: 'start'; readonly source: string }
  | { readonly kind: 'add'; readonly step: string }
  | { readonly kind: 'replace'; readonly step: string; readonly model: number };

/** By handles, or by curves along its limbs. */
export const POSED_BY = ['deform', 'curves'] as const;
export type PosedBy = (typeof POSED_BY)[number];

export class MatchModels {
  #asking: Asking | null = null;

  constructor(
    private readonly edits: MatchEdits,
    private readonly own: MatchState,
    private readonly parts: Pick<WingParts, 'state' | 'document' | 'runner' | 'workspaces' | 'messages'>,
  ) {}

  /** Asks for the model to match another with. @throws LissomError `no-model` */
  async start(): Promise<void> {
    const { document, runner, workspaces } = this.parts;
    const source = workspaces.openModel();
    if (source === undefined) throw new LissomError('no-model', t('error.no-model'));
    const { recipe } = document;
    const first = await runner.opened(recipe, source);
    if (document.recipe !== recipe) return;
    this.own.first.value = first;
    this.#ask({ kind: 'start', source });
  }

  add(): void {
    const { step } = this.edits;
    if (step && step.models.length < MAX_MATCHED) this.#ask({ kind: 'add', step: step.id });
  }

  replace(model: number): void {
    const { step } = this.edits;
    if (step) this.#ask({ kind: 'replace', step: step.id, model });
  }

  cancel(): void {
    this.parts.state.choice.value = null;
  }

  /** The number that the model asked for will have. Reads signals. */
  asked(): number | null {
    if (!this.parts.state.choosing.value || !this.#asking) return null;
    if (this.#asking.kind === 'replace') return this.#asking.model;
    return this.own.step.value?.models.length ?? 1;
  }

  /** Models that the document has already and that may be taken. Reads signals. */
  held(): readonly string[] {
    const recipe = this.parts.state.recipe.value;
    const { step } = this.own;
    const taken = step.value?.models ?? (this.#asking?.kind === 'start' ? [this.#asking.source] : []);
    return namesBefore(recipe, step.value).filter((name) => !taken.includes(name));
  }

  takeHeld(name: string): void {
    if (this.parts.state.choosing.peek()) this.#take(this.parts.document.recipe, name);
  }

  remove(model: number): void {
    const { step } = this.edits;
    if (!step || step.models.length <= 2) return;
    const order = step.models.map((_, at) => at).filter((at) => at !== model);
    this.#commit(t('history.match.remove-model', { name: step.models[model]! }), step, order);
  }

  /** Lets a model be the first: the skins are made of it. */
  makeSource(model: number): void {
    const { step } = this.edits;
    if (!step || model === 0) return;
    const order = [model, ...step.models.map((_, at) => at).filter((at) => at !== model)];
    this.#commit(t('history.match.source', { name: step.models[model]! }), step, order);
  }

  /**
   * Leads to where a model is given another pose; what comes of it is matched in its place. Where it has been posed already, that pose
   * is opened.
   */
  async pose(model: number, by: PosedBy): Promise<void> {
    const { document, messages, workspaces } = this.parts;
    const { step } = this.edits;
    const name = step?.models[model];
    if (!step || name === undefined) return;
    const held = edit.stepOf(document.recipe, name, by);
    if (held) {
      document.openStep(held.id);
      return;
    }
    const before = document.recipe;
    const posing = await workspaces.stepOn(by, name);
    if (!posing || document.recipe !== before) return;
    const recipe = edit.changedBefore(before, step.id, posing);
    try {
      crossCheck(recipe);
    } catch {
      messages.toast('warn', t('match.pose-held', { name }));
      return;
    }
    this.own.hold(step.id);
    document.commit(t('history.match.pose', { name }), recipe, { step: posing.id, item: null });
  }

  #ask(asking: Asking): void {
    const { state, document } = this.parts;
    const { recipe } = document;
    this.#asking = asking;
    state.choice.value = {
      recipe,
      workspace: 'match',
      drop: 'ui.drop.match',
      choose: (name, ref) => this.#choose(name, ref),
    };
  }

  #choose(wanted: string, ref: ModelRef): void {
    if (!this.parts.state.choosing.peek()) return;
    const { recipe } = this.parts.document;
    const held = edit.withModel(recipe, wanted, ref);
    const taken = this.edits.step?.models ?? (this.#asking?.kind === 'start' ? [this.#asking.source] : []);
    // The same model may be matched with itself, under another name.
    if (taken.includes(held.name)) {
      const name = edit.uniqueName(wanted, edit.takenNames(recipe));
      this.#take(edit.setModel(recipe, name, ref), name);
    } else this.#take(held.recipe, held.name);
  }

  #take(recipe: Recipe, name: string): void {
    const { state, document } = this.parts;
    const asking = this.#asking;
    if (!asking) return;
    const label = t('history.match.add', { name });
    if (asking.kind === 'start') {
      const id = edit.freeId('match', recipe);
      this.own.hold(id);
      const step = newMatchStep(id, [asking.source, name]);
      document.commit(label, edit.addStep(recipe, step), { step: id, item: null });
      state.tool.value = 'match-marker';
    } else {
      const step = edit.stepOf(recipe, asking.step, 'match');
      if (!step) return;
      const order: (number | null)[] = step.models.map((_, at) => at);
      if (asking.kind === 'add') order.push(null);
      else order[asking.model] = null;
      const models = order.map((at) => (at === null ? name : step.models[at]!));
      this.#commitIn(recipe, label, step, models, order);
    }
    state.choice.value = null;
  }

  #commit(label: string, step: MatchStep, order: readonly number[]): void {
    const models = order.map((at) => step.models[at]!);
    this.#commitIn(this.parts.document.recipe, label, step, models, order);
  }

  /** Whatever went on with a skin that is no more goes on with its model. */
  #commitIn(
    recipe: Recipe,
    label: string,
    step: MatchStep,
    models: readonly string[],
    order: readonly (number | null)[],
  ): void {
    const { document } = this.parts;
    this.own.hold(step.id);
    const next = withModels(step, models, order);
    const gone = step.models.filter((name) => !models.includes(name));
    const redirected = gone.reduce(
      (held, name) => edit.redirect(held, `${step.id}/${name}`, name),
      edit.replaceStep(recipe, next),
    );
    const left = producedNames(step).filter((_, at) => gone.includes(step.models[at]!));
    const outputs = redirected.outputs.filter((output) => !left.includes(output.step));
    const pruned = edit.pruneModels({ ...redirected, outputs });
    document.commit(label, pruned, { step: step.id, item: null });
  }
}

/** Names of the models that there are before a step. */
function namesBefore(recipe: Recipe, step: MatchStep | undefined): string[] {
  const at = step ? recipe.steps.findIndex(({ id }) => id === step.id) : recipe.steps.length;
  const made = recipe.steps
    .slice(0, at)
    .filter(({ type }) => stepRow(type).writes !== 'strands')
    .flatMap((each) => [...producedNames(each)]);
  return [...Object.keys(recipe.models), ...made];
}
