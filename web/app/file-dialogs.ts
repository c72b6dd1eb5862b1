// The system's file dialogs, where the browser has them; otherwise an input and a download.

export interface SaveOptions {
  readonly fileName: string;
  readonly extension: string;
  readonly description: string;
  readonly mimeType: string;
  /** The file saved into last time. */
  readonly into?: FileSystemFileHandle | undefined;
}

/** Tests have doubles of it. */
export interface FileDialogs {
  open(extensions: readonly string[]): Promise<File[]>;
  /** @returns the file written, to save into again; `undefined` for a download */
  save(bytes: Blob, options: SaveOptions): Promise<FileSystemFileHandle | undefined>;
}

export const browserDialogs: FileDialogs = {
  async open(extensions) {
    const { fileOpen } = await import('browser-fs-access');
    return fileOpen({ multiple: true, extensions: [...extensions], description: 'Lissom', id: 'lissom' });
  },
  async save(bytes, { fileName, extension, description, mimeType, into }) {
    const { fileSave } = await import('browser-fs-access');
    const options = { fileName, extensions: [extension], description, mimeTypes: [mimeType], id: 'lissom' };
    return (await fileSave(bytes, options, into ?? null)) ?? undefined;
  },
};
