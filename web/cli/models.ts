// Models of a recipe on disk: files beside it, built-in ones from the gallery.

import { existsSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { LissomError } from '../core/errors';
import type { Model } from '../core/model';
import { readModel } from '../io/formats';
import type { ImportNote } from '../io/notes';
import type { ModelRef } from '../recipe/recipe';
import type { ModelSource } from '../run/types';
import { readable } from './files';

/** Beside the bundle, in the built site, in the sources. */
const GALLERIES = ['./gallery/', '../dist/gallery/', '../public/gallery/', '../../public/gallery/'];

export class FolderModels implements ModelSource {
  /** What readers noticed, by the model's name in the recipe. */
  readonly notes = new Map<string, readonly ImportNote[]>();
  readonly #read = new Map<string, Promise<Model>>();

  /** @param folder  where the recipe is */
  constructor(
    private readonly folder: string,
    private readonly gallery = GALLERIES.map((place) => new URL(place, import.meta.url)).find((url) =>
      existsSync(url),
    ),
  ) {}

  load(name: string, ref: ModelRef): Promise<Model> {
    let reading = this.#read.get(name);
    if (!reading) {
      reading = this.#load(name, ref);
      this.#read.set(name, reading);
    }
    return reading;
  }

  async #load(name: string, ref: ModelRef): Promise<Model> {
    const file = 'file' in ref ? path.resolve(this.folder, ref.file) : await this.#builtin(ref.builtin);
    const { model, notes } = readModel(await readable('model-not-found', file), file);
    this.notes.set(name, notes);
    return 'file' in ref ? model : { ...model, name: ref.builtin };
  }

  async #builtin(name: string): Promise<string> {
    if (!this.gallery)
      throw new LissomError(
        'gallery-not-found',
        'The folder of built-in models is missing; install Lissom again.',
        'crash',
      );
    const folder = fileURLToPath(this.gallery);
    const { models } = JSON.parse(await readFile(path.join(folder, 'index.json'), 'utf8')) as {
      readonly models: readonly { readonly name: string; readonly file: string }[];
    };
    const entry = models.find((model) => model.name === name);
    if (entry) return path.join(folder, entry.file);
    const known = models.map((model) => model.name).join(', ');
    throw new LissomError(
      'model-not-found',
      `There is no built-in model ${JSON.stringify(name)}; there are ${known}.`,
    );
  }
}
