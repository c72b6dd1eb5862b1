// The page's requests, answered from memory.

import { vi } from 'vitest';

/** Answers by the file's name: what is not there is not found. */
export const serve = (files: Readonly<Record<string, BodyInit>>): void =>
  void vi.stubGlobal('fetch', async (address: string) => {
    const body = files[address.split('/').at(-1)!];
    return new Response(body ?? '', { status: body === undefined ? 404 : 200 });
  });

/** A model of the gallery's list. */
export const listed = (name: string, file: string, more: object = {}): object => ({
  name,
  file,
  title: name,
  licence: '',
  vertices: 8,
  ...more,
});
