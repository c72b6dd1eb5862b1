// Going from one workspace to another: the last step of its kind is opened, or one is started.

import { LissomError } from '../core/errors';
import * as edit from '../recipe/edit';
import type { Recipe, StepType } from '../recipe/recipe';
import { newDeformStep } from '../recipe/steps/deform';
import { newHairStep } from '../recipe/steps/hair';
import { scalpOf } from '../run/steps/hair/scalp';
import { primitivesOf } from '../tools/hair/style';
import type { MergeService, MessageService, WorkspaceService } from './api';
import type { Desk } from './desk';
import type { Document } from './document';
import type { Evaluator } from './evaluation';
import { t } from './i18n';
import type { State, WorkspaceId } from './state';

/** The head that hair starts on where the open model has no scalp. */
const HEAD = 'head-female';

interface Parts {
  readonly state: State;
  readonly document: Document;
  readonly desk: Desk;
  readonly evaluator: Pick<Evaluator, 'result' | 'settled'>;
  readonly messages: MessageService;
  readonly merge: Pick<MergeService, 'start'>;
}

export class Workspaces implements WorkspaceService {
  constructor(private readonly parts: Parts) {}

  async enter(workspace: WorkspaceId): Promise<void> {
    const { state, document } = this.parts;
    if (state.workspace.peek() === workspace && document.selection.step !== '') return;
    if (state.choosing.peek()) {
      // A part that was asked for and not chosen leaves no trace.
      state.merge.choosing.value = null;
      if (state.workspace.peek() === workspace) return;
    }
    const { steps } = document.recipe;
    // What was merged is deformed as a whole: deform steps before the merge are opened from the list of steps.
    const merged =
      workspace === 'deform' ? steps.findIndex(({ id }) => id === state.mergeStep.peek()?.id) : -1;
    const held = steps.slice(merged + 1).findLast(({ type }) => type === workspace);
    if (held) document.openStep(held.id);
    else if (workspace === 'hair') await this.#startHair();
    else if (workspace === 'merge') await this.#startMerge();
    else this.#startDeform();
  }

  growHere(): void {
    const from = this.#openModel();
    if (from !== undefined) this.#growOn(from);
  }

  /** @param offered  a hair step that this one takes the place of, unless something is drawn in it */
  #growOn(from: string, offered?: string): void {
    const { document, state } = this.parts;
    const step = edit.stepById(document.recipe, offered ?? '');
    const unused = step?.type === 'hair' && primitivesOf(step).length === 0;
    const recipe = unused ? edit.pruneModels(edit.removeStep(document.recipe, step.id)) : document.recipe;
    const id = freeId('hair', recipe);
    const grown = edit.addStep(recipe, { ...newHairStep(id, from), scalp: [] });
    document.commit(t('history.hair.start'), grown, { step: id, handle: null });
    state.tool.value = 'paint-scalp';
  }

  async #startHair(): Promise<void> {
    const { state, document, desk, evaluator, messages } = this.parts;
    const { recipe } = document;
    const open = evaluator.result.peek();
    const from = this.#openModel();
    const id = freeId('hair', recipe);
    if (open && from !== undefined && scalpOf({}, open.input.model).length > 0) {
      const grown = edit.addStep(recipe, newHairStep(id, from));
      document.commit(t('history.hair.start'), grown, { step: id, handle: null });
    } else if (document.isDirty) {
      // Somebody's work: the head joins it, and undo takes it out again.
      const name = HEAD in recipe.models ? HEAD : edit.uniqueName(HEAD, edit.takenNames(recipe));
      const joined = edit.addStep(edit.setModel(recipe, name, { builtin: HEAD }), newHairStep(id, name));
      document.commit(t('history.hair.start'), joined, { step: id, handle: null });
      const label = t('toast.hair-here');
      const run = () => this.#growOn(from!, id);
      messages.toast('info', t('toast.hair-head'), from === undefined ? undefined : { label, run });
    } else {
      await desk.open({ recipe: hairRecipeOn(HEAD), title: HEAD });
      if (open) messages.toast('info', t('toast.hair-head'));
    }
    state.tool.value = 'stream';
  }

  async #startMerge(): Promise<void> {
    const target = this.#openModel();
    if (target === undefined) throw new LissomError('no-model', t('error.no-model'));
    await this.parts.merge.start(target);
  }

  #startDeform(): void {
    const { document } = this.parts;
    const { recipe } = document;
    const at = recipe.steps.findIndex(({ id }) => id === document.selection.step);
    const open = recipe.steps[at];
    if (!open) return;
    if (open.type === 'merge') {
      this.#deformAfter(open.id);
      return;
    }
    const id = freeId('deform', recipe);
    // Before the hair, which follows the shape it grows on.
    const steps = [
      ...recipe.steps.slice(0, at),
      newDeformStep(id, open.model),
      { ...open, model: id },
      ...recipe.steps.slice(at + 1),
    ];
    document.commit(t('history.deform.start'), { ...recipe, steps }, { step: id, handle: null });
  }

  /** The merged model is deformed after the merge. */
  #deformAfter(merge: string): void {
    const { document } = this.parts;
    const id = freeId('deform', document.recipe);
    const recipe = edit.addStep(document.recipe, newDeformStep(id, merge));
    document.commit(t('history.deform.start'), recipe, { step: id, handle: null });
  }

  /** What a new step starts from: the open step's result, or its model where it does nothing yet. */
  #openModel(): string | undefined {
    const { document } = this.parts;
    const open = edit.stepById(document.recipe, document.selection.step);
    if (!open) return Object.keys(document.recipe.models)[0];
    if (open.type === 'merge') return open.id;
    return open.type === 'deform' && open.handles.length > 0 ? open.id : open.model;
  }
}

/** A new recipe of hair on a built-in head: nothing drawn yet. */
export const hairRecipeOn = (builtin: string): Recipe => ({
  lissom: 1,
  models: { [builtin]: { builtin } },
  steps: [newHairStep('hair 1', builtin)],
  outputs: [],
});

/** `hair 1`, `hair 2` … */
function freeId(kind: StepType, recipe: Recipe): string {
  const taken = edit.takenNames(recipe);
  for (let number = 1; ; number++) if (!taken.includes(`${kind} ${number}`)) return `${kind} ${number}`;
}
