// Going from one workspace to another: the last step of its kind is opened, or one is started.

import { stepById, takenNames } from '../recipe/edit';
import { freeName } from '../recipe/names';
import { type Recipe, type Step, stepRow, type WorkspaceId } from '../recipe/recipe';
import { mainInput, producedNames } from '../recipe/references';
import type { WingService, WorkspaceService } from './api';
import type { Document } from './document';
import type { State } from './state';

interface Parts {
  readonly state: State;
  readonly document: Document;
  readonly wings: () => Pick<WingService, 'load' | 'get'>;
}

export class Workspaces implements WorkspaceService {
  constructor(private readonly parts: Parts) {}

  async enter(workspace: WorkspaceId): Promise<void> {
    const { state, document, wings } = this.parts;
    if (state.workspace.peek() === workspace && document.selection.step !== '') return;
    if (state.choosing.peek()) {
      // A model that was asked for and not chosen leaves no trace.
      state.choice.value = null;
      if (state.workspace.peek() === workspace) return;
    }
    const wing = await wings().load(workspace);
    const held = wing.last ? wing.last(document.recipe) : lastOf(document.recipe, workspace);
    if (held === undefined) await wing.start();
    else document.openStep(held);
  }

  openModel(): string | undefined {
    const { document, wings } = this.parts;
    const open = stepById(document.recipe, document.selection.step);
    if (!open) return Object.keys(document.recipe.models)[0];
    const { writes, workspace } = stepRow(open.type);
    const wing = workspace === null ? undefined : wings().get(workspace);
    if (writes === 'strands' || wing?.isIdle?.(open)) return mainInput(open);
    return writes === 'mesh' ? open.id : (wing?.resultOf?.(open) ?? producedNames(open)[0]);
  }

  async stepOn(workspace: WorkspaceId, model: string): Promise<Step | undefined> {
    const { document, wings } = this.parts;
    const wing = await wings().load(workspace);
    return wing.stepOn?.(freeName(workspace, takenNames(document.recipe)), model);
  }

  async goOn(workspace: WorkspaceId): Promise<void> {
    const { document, wings } = this.parts;
    // Of several results the one, or all of them.
    const from = [this.openModel(), document.selection.step];
    const held = document.recipe.steps.findLast(
      (step) => stepRow(step.type).workspace === workspace && from.includes(mainInput(step)),
    );
    if (held) document.openStep(held.id);
    else await (await wings().load(workspace)).start();
  }
}

/** The last of the steps that are worked on there. */
export const lastOf = ({ steps }: Pick<Recipe, 'steps'>, workspace: WorkspaceId): string | undefined =>
  steps.findLast(({ type }) => stepRow(type).workspace === workspace)?.id;
