// Opening what a file holds: a mesh, a project archive, a recipe, a picture with its recipe inside, strands to look
// at. A document is replaced only once what was opened has proved usable, so a bad file costs nothing.

import { LissomError } from '../core/errors';
import type { Groom } from '../core/strands';
import { readModel, readProject, readStrands } from '../io/index';
import { isPng } from '../io/png-text';
import { isHair } from '../io/strands/hair';
import { hasObjLines } from '../io/strands/obj-lines';
import { newDeformStep, uniqueName } from '../recipe/edit';
import { isReserved, parseRecipe } from '../recipe/parse';
import type { Recipe } from '../recipe/recipe';
import type { MergeService, MessageService } from './api';
import type { Desk } from './desk';
import type { Evaluator } from './evaluation';
import { viewed } from './hair/viewed';
import { t } from './i18n';
import type { ModelStore } from './model-store';
import { recipeOf } from './picture';
import type { State } from './state';

const MESHES = ['.obj', '.ply', '.stl', '.glb', '.gltf', '.off'];
export const EXTENSIONS = [...MESHES, '.hair', '.zip', '.json', '.png'];

export interface ReadFile {
  readonly name: string;
  readonly bytes: Uint8Array;
}

interface Parts {
  readonly state: State;
  readonly evaluator: Pick<Evaluator, 'result'>;
  readonly models: Pick<ModelStore, 'add' | 'read'>;
  readonly desk: Pick<Desk, 'open'>;
  readonly messages: MessageService;
  readonly merge: Pick<MergeService, 'choosePart'>;
}

export class FileOpener {
  constructor(private readonly parts: Parts) {}

  /** Several files: a model or a recipe with what it refers to. */
  async open(files: readonly ReadFile[]): Promise<void> {
    const project = files.find(({ name }) => hasEnding(name, ['.zip']));
    if (project) return this.#openProject(project);
    const recipe = files.find(({ name }) => hasEnding(name, ['.json']));
    if (recipe)
      return this.#openRecipe(
        recipe,
        files.filter((file) => file !== recipe),
      );
    const picture = files.find(({ name, bytes }) => hasEnding(name, ['.png']) || isPng(bytes));
    if (picture)
      return this.#openWith(
        recipeOf(picture.bytes, picture.name),
        files.filter((file) => file !== picture),
        stem(picture.name),
      );
    const mesh = files.find(({ name }) => hasEnding(name, [...MESHES, '.hair'])) ?? files[0]!;
    if (files.length > 1) this.parts.messages.toast('info', t('error.several-files', { name: mesh.name }));
    if (isHair(mesh.bytes) || hasEnding(mesh.name, ['.hair'])) this.#view(readStrands(mesh.bytes, mesh.name));
    else if (hasEnding(mesh.name, ['.obj']) && hasObjLines(mesh.bytes)) await this.#openLines(mesh);
    else await this.#openMesh(mesh);
  }

  /** An OBJ with lines: hair alone, hair with its head, or a model with a few loose edges. */
  async #openLines(file: ReadFile): Promise<void> {
    const { messages, state } = this.parts;
    const { name } = file;
    const groom = strandsIn(file);
    if (!groom) return this.#openMesh(file);
    const again = (act: () => void | Promise<void>) => async () => {
      try {
        await act();
      } catch (error) {
        messages.failed(error);
      }
    };
    if (!groom.head) return this.#view(groom);
    if (state.workspace.peek() === 'hair') {
      this.#view(groom);
      const run = again(() => this.#openMesh(file));
      messages.toast('info', t('toast.lines-seen', { name }), { label: t('toast.open-model'), run });
      return;
    }
    await this.#openMesh(file);
    const run = again(() => this.#view(groom));
    messages.toast('info', t('toast.lines', { name }), { label: t('toast.see-lines'), run });
  }

  #view(groom: Groom): void {
    const { state, evaluator } = this.parts;
    state.dialog.value = null;
    state.hair.viewed.value = viewed(groom, evaluator.result.peek());
  }

  async #openMesh({ name, bytes }: ReadFile): Promise<void> {
    const { models, desk, merge, state } = this.parts;
    // Before it is kept under a name: a file that cannot be read leaves no trace.
    readModel(bytes, name);
    const { file } = await models.add(name, bytes);
    const { notes } = await models.read({ file });
    const model = modelName(name);
    if (state.choosing.peek()) {
      merge.choosePart(model, { file });
      return;
    }
    const id = uniqueName('deform 1', [model]);
    const recipe: Recipe = {
      lissom: 1,
      models: { [model]: { file } },
      steps: [newDeformStep(id, model)],
      outputs: [],
    };
    await desk.open({ recipe, title: model, imported: notes, own: true });
  }

  async #openProject({ name, bytes }: ReadFile): Promise<void> {
    const { recipeJson, files } = readProject(bytes);
    await this.#openWith(
      parseRecipe(recipeJson),
      [...files].map(([file, held]) => ({ name: file, bytes: held })),
      stem(name),
    );
  }

  async #openRecipe({ name, bytes }: ReadFile, beside: readonly ReadFile[]): Promise<void> {
    await this.#openWith(parseRecipe(new TextDecoder().decode(bytes)), beside, stem(name));
  }

  /** A recipe with the meshes it names; those that were renamed on the way in are renamed in it too. */
  async #openWith(recipe: Recipe, beside: readonly ReadFile[], title: string): Promise<void> {
    const kept = new Map<string, string>();
    for (const { name, bytes } of beside) kept.set(name, (await this.parts.models.add(name, bytes)).file);
    const models = Object.fromEntries(
      Object.entries(recipe.models).map(([name, ref]) => [
        name,
        'file' in ref ? { file: kept.get(ref.file) ?? ref.file } : ref,
      ]),
    );
    await this.parts.desk.open({ recipe: { ...recipe, models }, title, own: true });
  }
}

/** @returns `null` where the lines are no strands: a model may have lines that are of no use here */
function strandsIn({ name, bytes }: ReadFile): Groom | null {
  try {
    return readStrands(bytes, name);
  } catch (error) {
    if (error instanceof LissomError && error.fault === 'input') return null;
    throw error;
  }
}

const hasEnding = (name: string, endings: readonly string[]): boolean =>
  endings.some((ending) => name.toLowerCase().endsWith(ending));

const stem = (name: string): string => name.replace(/^.*[/\\]/, '').replace(/(.)\.[^.]*$/, '$1');

/** A name a recipe takes (letters, digits, space . _ -), as near to the file's as may be. */
function modelName(file: string): string {
  const name = stem(file)
    .replace(/[^\p{L}\p{N} ._-]+/gu, ' ')
    .trim()
    .replace(/^[^\p{L}\p{N}]+/u, '')
    .slice(0, 64);
  return name === '' || isReserved(name) ? `${name} model`.trim() : name;
}
