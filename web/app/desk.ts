// Where documents are laid open. Whatever is opened is first proved usable; only then does it take the
// place of what was there, and what was there is kept as a restore point.

import { cancelled, type Finding } from '../core/errors';
import { stepById } from '../recipe/edit';
import type { Recipe } from '../recipe/recipe';
import { referencesOf } from '../recipe/references';
import type { MessageService, WingService } from './api';
import type { Autosave } from './autosave';
import { type Document, openingSelection } from './document';
import type { RunnerPort } from './evaluated';
import { factsOf } from './figures';
import { t } from './i18n';
import type { State } from './state';

export interface Opening {
  readonly recipe: Recipe;
  /** Shown at the top, and the stem of file names. */
  readonly title: string;
  /** For an imported file: what its reader noticed. A report is made of it and of what the kernel finds. */
  readonly imported?: readonly (Finding & { readonly message?: string })[];
  /** The address it came from, so that a reload finds the visitor's changes to it again. */
  readonly link?: string;
  /** Whether it is work of one's own from the start, and saved at once: a file of one's own. */
  readonly own?: boolean;
  /** The way out, until it has taken the place of what was there. */
  readonly signal?: AbortSignal;
}

export class Desk {
  constructor(
    private readonly state: State,
    private readonly document: Document,
    private readonly runner: Pick<RunnerPort, 'opened'>,
    private readonly wings: () => Pick<WingService, 'loadFor' | 'open'>,
    private readonly autosave: Autosave,
    private readonly messages: MessageService,
  ) {}

  /** @throws LissomError  whatever is wrong with it; then nothing has changed */
  async open({ recipe, title, imported, link, own = false, signal }: Opening): Promise<void> {
    const selection = openingSelection(recipe);
    const step = stepById(recipe, selection.step);
    const first = step ? referencesOf(step)[0]?.name : Object.keys(recipe.models)[0];
    const input =
      first === undefined ? null : await this.runner.opened(recipe, first, signal ? { signal } : {});
    await this.wings().loadFor(recipe, selection.step);
    if (signal?.aborted) throw cancelled();
    if (await this.autosave.setAside()) this.messages.toast('info', t('toast.kept'));
    this.autosave.begin({ own, link });
    this.state.title.value = title;
    this.state.hint.value = null;
    this.state.importReport.value = null;
    this.document.replace(recipe, t('history.open', { name: title }), selection);
    this.state.tool.value = this.wings().open.peek()?.wing.tools[0] ?? '';
    if (own) this.autosave.touch();
    if (!imported || !input) return;
    const findings = [...imported, ...input.opened.findings];
    this.state.importReport.value = { file: input.model.name, facts: factsOf(input), findings };
    if (findings.length === 0) return;
    const text = t('toast.opened-with-findings', { name: input.model.name, count: findings.length });
    const show = () => {
      this.state.dialog.value = 'import-report';
    };
    this.messages.toast('info', text, { label: t('toast.show'), run: show });
  }
}
