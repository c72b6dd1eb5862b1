// The built-in models and finished examples, as public/gallery/index.json lists them.

import { type ReadonlySignal, signal } from '@preact/signals';
import { LissomError } from '../core/errors';
import { type BuiltIn, builtInAtOnce } from '../io/built-in';
import type { ReadResult } from '../io/reading';
import { parseRecipe } from '../recipe/parse';
import type { Recipe, WorkspaceId } from '../recipe/recipe';
import type { GalleryEntry, GalleryService } from './api';
import { t } from './i18n';

export interface IndexedModel extends BuiltIn {
  readonly title: string;
  readonly licence: string;
  readonly vertices: number;
  readonly scalp?: boolean;
  readonly worn?: boolean;
}

interface Index {
  readonly models: readonly IndexedModel[];
  readonly examples: readonly {
    readonly name: string;
    readonly file: string;
    readonly title: string;
    readonly model: string;
    /** Where it is worked on. */
    readonly workspace: WorkspaceId;
  }[];
}

export class Gallery implements GalleryService {
  readonly #entries = signal<readonly GalleryEntry[]>([]);
  #index: Promise<Index> | undefined;

  /**
   * @param base  address of the gallery's folder, ending in a slash
   * @param show  opens a recipe as a new document, with a way out
   * @param bare  the recipe that a model without an example opens with
   * @param make  makes a model that no file holds of the bytes of another's
   */
  constructor(
    private readonly base: string,
    private readonly show: (recipe: Recipe, title: string) => Promise<void>,
    private readonly bare: (entry: GalleryEntry) => Promise<Recipe>,
    private readonly make: (entry: IndexedModel, bytes: Uint8Array) => Promise<ReadResult>,
  ) {}

  get entries(): ReadonlySignal<readonly GalleryEntry[]> {
    return this.#entries;
  }

  /** Reads the list; called once the first picture stands. */
  async start(): Promise<void> {
    const { models, examples } = await this.#list();
    const thumbnail = (name: string) => `${this.base}thumbnails/${name}.webp`;
    const finished = examples.map(({ name, title, file, model, workspace }) => {
      const of = models.find((each) => each.name === model);
      const { licence = '', vertices = 0, scalp = false } = of ?? {};
      const made = of?.made !== undefined;
      return {
        name,
        title,
        licence,
        vertices,
        scalp,
        made,
        workspace,
        thumbnail: thumbnail(name),
        recipe: file,
      };
    });
    const bare = models.map(({ name, title, licence, vertices, made, scalp = false, worn = false }) => ({
      worn,
      name,
      title,
      licence,
      vertices,
      scalp,
      made: made !== undefined,
      thumbnail: thumbnail(name),
    }));
    this.#entries.value = [...finished, ...bare];
  }

  async open(entry: GalleryEntry): Promise<void> {
    const recipe = entry.recipe ? await this.recipe(entry.recipe) : await this.bare(entry);
    await this.show(recipe, entry.title);
  }

  async recipe(file: string): Promise<Recipe> {
    return parseRecipe(new TextDecoder().decode(await this.#fetch(file)));
  }

  /** A built-in model; what ModelStore asks for. */
  async model(name: string): Promise<ReadResult> {
    const entry = (await this.#list()).models.find((each) => each.name === name);
    if (!entry) throw new LissomError('model-not-found', t('error.link-foreign', { name }));
    const bytes = await this.#fetch(entry.file);
    return entry.made ? this.make(entry, bytes) : builtInAtOnce(entry, bytes);
  }

  async #list(): Promise<Index> {
    this.#index ??= this.#fetch('index.json').then((bytes) => JSON.parse(new TextDecoder().decode(bytes)));
    try {
      return await this.#index;
    } catch (error) {
      this.#index = undefined;
      throw error;
    }
  }

  async #fetch(file: string): Promise<Uint8Array> {
    try {
      const answer = await fetch(this.base + file);
      if (!answer.ok) throw new Error(String(answer.status));
      return new Uint8Array(await answer.arrayBuffer());
    } catch (error) {
      const detail = error instanceof Error ? error.message : String(error);
      throw new LissomError('gallery', t('error.gallery', { name: file, detail }), 'crash');
    }
  }
}
