// Models of a recipe on disk: files beside it, built-in ones from the gallery.

import { existsSync } from 'node:fs';
import { readFile, realpath } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { LissomError } from '../core/errors';
import type { Model } from '../core/model';
import { type BuiltIn, builtInAtOnce } from '../io/built-in';
import { readModel } from '../io/formats';
import type { ImportNote } from '../io/notes';
import type { ReadResult } from '../io/reading';
import type { ModelRef } from '../recipe/recipe';
import type { ModelSource } from '../run/types';
import { readable } from './files';

/** Beside the bundle, in the built site, in the sources. */
const GALLERIES = ['./gallery/', '../dist/gallery/', '../public/gallery/', '../../public/gallery/'];

export class FolderModels implements ModelSource {
  /** What readers noticed, by the model's name in the recipe. */
  readonly notes = new Map<string, readonly ImportNote[]>();
  readonly #read = new Map<string, Promise<Model>>();

  /**
   * @param folder  where the recipe is
   * @param rights  whether its models may lie anywhere else: a recipe is anybody's, and what it names is read and shown
   */
  constructor(
    private readonly folder: string,
    private readonly rights: { readonly allowOutside: boolean } = { allowOutside: false },
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
    const { model, notes } = 'file' in ref ? await this.#file(ref.file) : await this.#builtin(ref.builtin);
    this.notes.set(name, notes);
    return model;
  }

  async #file(name: string): Promise<ReadResult> {
    const file = await this.#beside(name);
    return readModel(await readable('model-not-found', file, 'mesh'), file);
  }

  /** Links are followed before it is asked where a file lies. */
  async #beside(name: string): Promise<string> {
    const file = path.resolve(this.folder, name);
    if (this.rights.allowOutside) return file;
    const folder = await realpath(this.folder).catch(() => path.resolve(this.folder));
    const place = await realpath(file).catch(() => undefined);
    const inside = (from: string, to: string) => {
      const way = path.relative(from, to);
      return way !== '' && way.split(path.sep)[0] !== '..' && !path.isAbsolute(way);
    };
    // What is not there is asked about by its name only, so that nobody learns what lies elsewhere.
    if (place === undefined ? inside(path.resolve(this.folder), file) : inside(folder, place)) return file;
    throw new LissomError(
      'model-outside',
      `${name} lies outside the recipe's folder; move it beside the recipe, or allow it with --allow-outside.`,
    );
  }

  async #builtin(name: string): Promise<ReadResult> {
    if (!this.gallery)
      throw new LissomError(
        'gallery-not-found',
        'The folder of built-in models is missing; install Lissom again.',
        'crash',
      );
    const folder = fileURLToPath(this.gallery);
    const { models } = JSON.parse(await readFile(path.join(folder, 'index.json'), 'utf8')) as {
      readonly models: readonly BuiltIn[];
    };
    const entry = models.find((model) => model.name === name);
    if (entry) {
      const bytes = await readable('model-not-found', path.join(folder, entry.file), 'mesh');
      return builtInAtOnce(entry, bytes);
    }
    const known = models.map((model) => model.name).join(', ');
    throw new LissomError(
      'model-not-found',
      `There is no built-in model ${JSON.stringify(name)}; there are ${known}.`,
    );
  }
}
