// Files in and out: meshes, project archives and recipes; exports and pictures. A document is replaced only
// once what was opened has proved usable, so a bad file costs nothing.

import { LissomError } from '../core/errors';
import { type Model, withPositions } from '../core/model';
import { readModel, readProject, writeModel, writeProject } from '../io/index';
import type { StrandFormat } from '../io/strands/options';
import { newDeformStep, uniqueName } from '../recipe/edit';
import { formatRecipe } from '../recipe/format';
import { parseRecipe } from '../recipe/parse';
import type { Recipe } from '../recipe/recipe';
import type { ViewportPort } from '../view/types';
import type { ExportChoice, ExportFormat, FileService, MessageService } from './api';
import type { Desk } from './desk';
import type { Document } from './document';
import type { Evaluator } from './evaluation';
import type { FileDialogs } from './file-dialogs';
import { STRAND_MIME, strandChoices, strandsFile } from './hair/export';
import { t } from './i18n';
import type { ModelStore } from './model-store';
import type { State } from './state';

const MESHES = ['.obj', '.ply', '.stl', '.glb', '.gltf', '.off'];
const EXTENSIONS = [...MESHES, '.zip', '.json'];
const MIME: Readonly<Record<ExportFormat, string>> = {
  obj: 'model/obj',
  ply: 'application/octet-stream',
  stl: 'model/stl',
  glb: 'model/gltf-binary',
};
const PICTURE = { width: 1920, height: 1080 };

export interface FileParts {
  readonly state: State;
  readonly document: Document;
  readonly models: ModelStore;
  readonly desk: Desk;
  readonly evaluator: Pick<Evaluator, 'result' | 'settled'>;
  readonly viewport: ViewportPort | null;
  readonly messages: MessageService;
  readonly dialogs: FileDialogs;
}

export class Files implements FileService {
  /** The project file saved into last, and the document it belongs to. */
  #project: { readonly handle: FileSystemFileHandle; readonly title: string } | null = null;

  readonly exportChoices: readonly ExportChoice[] = (['obj', 'ply', 'stl', 'glb'] as const).map((format) => ({
    format,
    label: t(`export.${format}`),
    keeps: t(`export.${format}.keeps`),
  }));

  readonly strandChoices = strandChoices();

  constructor(private readonly parts: FileParts) {}

  async open(): Promise<void> {
    await this.openFiles(await this.parts.dialogs.open(EXTENSIONS));
  }

  async openFiles(files: readonly File[]): Promise<void> {
    const { state, messages } = this.parts;
    const [first] = files;
    if (!first) return;
    state.busy.value = { label: t('busy.reading', { name: first.name }), fraction: null, cancel: null };
    try {
      const read = await Promise.all(
        files.map(async (file) => ({ name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) })),
      );
      await this.#openRead(read);
    } catch (error) {
      messages.failed(error);
    } finally {
      state.busy.value = null;
    }
  }

  async #openRead(files: readonly ReadFile[]): Promise<void> {
    const project = files.find(({ name }) => hasEnding(name, ['.zip']));
    if (project) return this.#openProject(project);
    const recipe = files.find(({ name }) => hasEnding(name, ['.json']));
    if (recipe)
      return this.#openRecipe(
        recipe,
        files.filter((file) => file !== recipe),
      );
    const mesh = files.find(({ name }) => hasEnding(name, MESHES)) ?? files[0]!;
    if (files.length > 1) this.parts.messages.toast('info', t('error.several-files', { name: mesh.name }));
    return this.#openMesh(mesh);
  }

  async #openMesh({ name, bytes }: ReadFile): Promise<void> {
    const { models, desk } = this.parts;
    // Before it is kept under a name: a file that cannot be read leaves no trace.
    readModel(bytes, name);
    const { file } = await models.add(name, bytes);
    const { notes } = await models.read({ file });
    const model = modelName(name);
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

  save(): Promise<void> {
    return this.#save(this.#project?.title === this.#title ? this.#project.handle : undefined);
  }

  saveAs(): Promise<void> {
    return this.#save(undefined);
  }

  async #save(into: FileSystemFileHandle | undefined): Promise<void> {
    const { document, models, messages, dialogs } = this.parts;
    const { recipe } = document;
    const files = new Map<string, Uint8Array>();
    for (const ref of Object.values(recipe.models)) {
      const held = 'file' in ref ? models.get(ref.file) : undefined;
      if (held) files.set(held.file, held.bytes);
    }
    const bytes = writeProject({ recipeJson: formatRecipe(recipe), files });
    const fileName = `${this.#title}.zip`;
    const handle = await dialogs.save(new Blob([bytes as BlobPart]), {
      fileName,
      extension: '.zip',
      description: t('file.project'),
      mimeType: 'application/zip',
      into,
    });
    this.#project = handle ? { handle, title: this.#title } : null;
    document.markSaved(recipe);
    messages.toast('good', t('toast.saved', { name: handle?.name ?? fileName }));
  }

  async exportModel(format: ExportFormat): Promise<void> {
    const { state, evaluator, dialogs, messages } = this.parts;
    await evaluator.settled();
    const shown = evaluator.result.peek();
    if (!shown) throw new LissomError('no-model', t('error.no-model'));
    const fileName = `${this.#title}.${format}`;
    state.busy.value = { label: t('busy.writing', { name: fileName }), fraction: null, cancel: null };
    try {
      const model = withPositions(shown.input.model, shown.positions);
      const bytes = writeModel(model, format);
      const handle = await dialogs.save(new Blob([bytes as BlobPart]), {
        fileName,
        extension: `.${format}`,
        description: t(`export.${format}`),
        mimeType: MIME[format],
      });
      messages.toast('good', exported(handle?.name ?? fileName, model, bytes));
    } finally {
      state.busy.value = null;
    }
  }

  async exportStrands(format: StrandFormat, guidesOnly: boolean): Promise<void> {
    const { state, evaluator, dialogs, messages } = this.parts;
    await evaluator.settled();
    const shown = evaluator.result.peek();
    if (!shown) throw new LissomError('no-model', t('error.no-model'));
    const fileName = `${this.#title}.${format}`;
    state.busy.value = { label: t('busy.writing', { name: fileName }), fraction: null, cancel: null };
    // The sentence is drawn before the page is busy with the file.
    await new Promise((drawn) => setTimeout(drawn, 30));
    try {
      const bytes = strandsFile(shown, this.#title, format, guidesOnly);
      const handle = await dialogs.save(new Blob([bytes as BlobPart]), {
        fileName,
        extension: `.${format}`,
        description: t(`export.strands.${format}`),
        mimeType: STRAND_MIME[format],
      });
      messages.toast('good', t('toast.saved', { name: handle?.name ?? fileName }));
    } finally {
      state.busy.value = null;
    }
  }

  async screenshot(): Promise<void> {
    const { viewport, dialogs, messages } = this.parts;
    if (!viewport) return;
    const fileName = `${this.#title}.png`;
    const picture = await viewport.screenshot(PICTURE.width, PICTURE.height);
    const handle = await dialogs.save(picture, {
      fileName,
      extension: '.png',
      description: t('file.picture'),
      mimeType: 'image/png',
    });
    messages.toast('good', t('toast.screenshot', { name: handle?.name ?? fileName }));
  }

  get #title(): string {
    return this.parts.state.title.peek() || t('app.name').toLowerCase();
  }
}

interface ReadFile {
  readonly name: string;
  readonly bytes: Uint8Array;
}

/** What the export did to the vertex order, found by reading back what was written. */
function exported(name: string, model: Model, bytes: Uint8Array): string {
  const vertices = model.positions.length / 3;
  const { positions } = readModel(bytes, name).model;
  if (positions.length !== model.positions.length) return t('toast.exported-only', { name });
  const reordered = reorderedVertices(model.positions, positions);
  return t('toast.exported', { name, vertices, reordered });
}

/** How many vertices are elsewhere than single precision can explain. */
function reorderedVertices(written: Float64Array, read: Float64Array): number {
  let count = 0;
  for (let v = 0; v < written.length; v += 3) {
    let off = false;
    for (let k = v; k < v + 3; k++) {
      const [a, b] = [written[k]!, read[k]!];
      off ||= Number.isFinite(a) && Math.abs(a - b) > 1e-6 * Math.max(1e-30, Math.abs(a));
    }
    if (off) count++;
  }
  return count;
}

const hasEnding = (name: string, endings: readonly string[]): boolean =>
  endings.some((ending) => name.toLowerCase().endsWith(ending));

const stem = (name: string): string => name.replace(/^.*[/\\]/, '').replace(/(.)\.[^.]*$/, '$1');

/** A name a recipe takes (letters, digits, space . _ -), as near to the file's as may be. */
const modelName = (file: string): string =>
  stem(file)
    .replace(/[^\p{L}\p{N} ._-]+/gu, ' ')
    .trim()
    .replace(/^[^\p{L}\p{N}]+/u, '')
    .slice(0, 64) || 'model';
