// Files in and out: what is opened goes to open-files.ts; projects, exports and pictures are written here.

import { LissomError } from '../core/errors';
import { type Model, withPositions } from '../core/model';
import { checkFileSize } from '../io/budget';
import { readModel, writeModel, writeProject } from '../io/index';
import { formatRecipe } from '../recipe/format';
import type { ViewportPort } from '../view/types';
import type { ExportChoice, ExportFormat, FileService, MessageService, WingService } from './api';
import type { Desk } from './desk';
import type { Document } from './document';
import type { Evaluation, EvaluatorPort } from './evaluated';
import type { FileDialogs, SaveOptions } from './file-dialogs';
import { t } from './i18n';
import type { ModelStore } from './model-store';
import { EXTENSIONS, FileOpener } from './open-files';
import { pictureOf } from './picture';
import type { State } from './state';
import type { ExportGroup } from './wing';

const MIME: Readonly<Record<ExportFormat, string>> = {
  obj: 'model/obj',
  ply: 'application/octet-stream',
  stl: 'model/stl',
  glb: 'model/gltf-binary',
};
/** Pixels along the longer side of a picture. */
const PICTURE = 3840;
/** A slow machine settles for a coarser picture after so many ms. */
const PATIENCE = 15_000;

export interface FileParts {
  readonly state: State;
  readonly document: Document;
  readonly models: ModelStore;
  readonly desk: Desk;
  readonly evaluator: EvaluatorPort;
  readonly viewport: ViewportPort | null;
  readonly messages: MessageService;
  readonly dialogs: FileDialogs;
  readonly wings: () => Pick<WingService, 'load' | 'open'>;
}

export class Files implements FileService {
  /** The project file saved into last, and the document it belongs to. */
  #project: { readonly handle: FileSystemFileHandle; readonly title: string } | null = null;

  readonly exportChoices: readonly ExportChoice[] = (['obj', 'ply', 'stl', 'glb'] as const).map((format) => ({
    format,
    label: t(`export.${format}`),
    keeps: t(`export.${format}.keeps`),
  }));

  readonly #opener: FileOpener;

  constructor(private readonly parts: FileParts) {
    this.#opener = new FileOpener(parts);
  }

  async open(): Promise<void> {
    await this.openFiles(await this.parts.dialogs.open(EXTENSIONS));
  }

  async openFiles(files: readonly File[]): Promise<void> {
    const { state, messages } = this.parts;
    const [first] = files;
    if (!first) return;
    state.busy.value = { label: t('busy.reading', { name: first.name }), fraction: null, cancel: null };
    try {
      // Before it takes memory.
      for (const { name, size } of files) checkFileSize(name, size);
      const read = await Promise.all(
        files.map(async (file) => ({ name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) })),
      );
      await this.#opener.open(read);
    } catch (error) {
      messages.failed(error);
    } finally {
      state.busy.value = null;
    }
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

  exportModels(): readonly Model[] {
    return this.parts.wings().open.value?.wing.results?.() ?? [];
  }

  exportModel(format: ExportFormat, number?: number): Promise<void> {
    const kind = { extension: `.${format}`, description: t(`export.${format}`), mimeType: MIME[format] };
    return this.#write(kind, (shown) => {
      const several = number === undefined ? undefined : this.exportModels()[number];
      const model = several ?? withPositions(shown.shown.model, shown.positions);
      const bytes = writeModel(model, format);
      return { bytes, said: (name) => exported(name, model, bytes) };
    });
  }

  exportGroup(): ExportGroup | undefined {
    return this.parts.wings().open.value?.wing.exports;
  }

  async exportOf(group: ExportGroup, format: string, option: boolean): Promise<void> {
    const choice = group.choices.find((each) => each.format === format);
    if (!choice) return;
    const { label: description, mimeType } = choice;
    const kind = { extension: `.${format}`, description, mimeType };
    await this.#write(kind, async (shown) => ({
      bytes: await group.write(shown, this.#title, format, option),
    }));
  }

  async screenshot(): Promise<void> {
    const { viewport, document, state } = this.parts;
    if (!viewport) return;
    const stop = new AbortController();
    const kind = { extension: '.png', description: t('file.picture'), mimeType: 'image/png' };
    const cancel = () => stop.abort();
    await this.#write(kind, async () => {
      const recipe = state.viewing.peek() ? null : document.recipe;
      const { width, height } = pictureSize(viewport.size);
      const onProgress = (fraction: number) => {
        state.busy.value = { label: t('busy.picture'), fraction, cancel };
      };
      const png = await viewport.screenshot(width, height, {
        onProgress,
        patience: PATIENCE,
        signal: stop.signal,
      });
      return { bytes: pictureOf(new Uint8Array(await png.arrayBuffer()), recipe) };
    });
  }

  /** Writes what the open step shows, once it is all there. */
  async #write(
    kind: Pick<SaveOptions, 'extension' | 'description' | 'mimeType'>,
    make: (shown: Evaluation) => Written | Promise<Written>,
  ): Promise<void> {
    const { state, evaluator, dialogs, messages } = this.parts;
    await evaluator.settled();
    const shown = evaluator.result.peek();
    if (!shown) throw new LissomError('no-model', t('error.no-model'));
    const fileName = this.#title + kind.extension;
    state.busy.value = { label: t('busy.writing', { name: fileName }), fraction: null, cancel: null };
    // The sentence is drawn before the page is busy with the file.
    await new Promise((drawn) => setTimeout(drawn, 30));
    try {
      const { bytes, said = (name: string) => t('toast.saved', { name }) } = await make(shown);
      const handle = await dialogs.save(new Blob([bytes as BlobPart]), { fileName, ...kind });
      messages.toast('good', said(handle?.name ?? fileName));
    } finally {
      state.busy.value = null;
    }
  }

  get #title(): string {
    return this.parts.state.title.peek() || t('app.name').toLowerCase();
  }
}

interface Written {
  readonly bytes: Uint8Array;
  /** What is told of it; that it has been saved, if nothing else. */
  readonly said?: (name: string) => string;
}

/** What is seen, as large as a large screen. */
function pictureSize({ width, height }: { readonly width: number; readonly height: number }) {
  const scale = PICTURE / Math.max(width, height);
  return { width: Math.round(scale * width), height: Math.round(scale * height) };
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
