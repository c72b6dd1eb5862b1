// Opening what a file holds: a mesh, a project archive, a recipe, a picture with its recipe inside, or something that
// a wing knows to look at. A document is replaced only once what was opened has proved usable, so a bad file costs nothing.

import { readModel, readProject } from '../io/index';
import { LOOSE_ENDINGS, looseKind } from '../io/loose';
import { isPng } from '../io/png-text';
import type { ReadResult } from '../io/reading';
import { isReserved, parseRecipe } from '../recipe/parse';
import type { Recipe } from '../recipe/recipe';
import type { MessageService, WingService } from './api';
import type { Desk } from './desk';
import { t } from './i18n';
import type { ModelStore } from './model-store';
import { recipeOf } from './picture';
import type { State } from './state';
import { wingFor } from './wings';

const MESHES = ['.obj', '.ply', '.stl', '.glb', '.gltf', '.off'];
export const EXTENSIONS = [...MESHES, ...LOOSE_ENDINGS, '.zip', '.json', '.png'];

export interface ReadFile {
  readonly name: string;
  readonly bytes: Uint8Array;
}

interface Parts {
  readonly state: State;
  readonly models: Pick<ModelStore, 'add' | 'open'>;
  readonly desk: Pick<Desk, 'open'>;
  readonly messages: MessageService;
  readonly wings: () => Pick<WingService, 'load'>;
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
    const mesh = files.find(({ name }) => hasEnding(name, [...MESHES, ...LOOSE_ENDINGS])) ?? files[0]!;
    if (files.length > 1) this.parts.messages.toast('info', t('error.several-files', { name: mesh.name }));
    const loose = looseKind(mesh.bytes, mesh.name);
    const wing = loose && wingFor(loose.kind);
    if (!loose || !wing) return this.#openMesh(mesh);
    const read = loose.only ? undefined : readModel(mesh.bytes, mesh.name);
    const openModel = () => this.#openMesh(mesh, read);
    const { name, bytes } = mesh;
    await (await this.parts.wings().load(wing)).take?.({ name, bytes, model: read?.model, openModel });
  }

  /** @param read  what was read of it, if that is known already */
  async #openMesh({ name, bytes }: ReadFile, read?: ReadResult): Promise<void> {
    const { models, desk, wings, state } = this.parts;
    const { file, notes } = await models.open(name, bytes, read);
    const model = modelName(name);
    const choice = state.choosing.peek();
    if (choice) {
      choice.choose(model, { file });
      return;
    }
    const home = await wings().load(state.home);
    const recipe = home.opening!({ name: model, ref: { file } })!;
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
