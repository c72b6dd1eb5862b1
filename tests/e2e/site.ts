// A copy of the built site on a server of its own, which can be stopped and whose files can change.

import { createHash } from 'node:crypto';
import {
  cpSync,
  existsSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  renameSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { createServer, type IncomingMessage, type Server, type ServerResponse } from 'node:http';
import type { AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { writePrecacheList } from '../../scripts/precache-plugin.ts';

const TYPES: Readonly<Record<string, string>> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.json': 'application/json',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
  '.txt': 'text/plain; charset=utf-8',
};

/** A file's name with another hash in it. */
const nameIn = (release: string, file: string): string =>
  file.replace(
    /-[\w-]{8}(?=\.\w+$)/,
    `-${createHash('sha256')
      .update(release + file)
      .digest('hex')
      .slice(0, 8)}`,
  );

export class Site {
  readonly folder = mkdtempSync(path.join(tmpdir(), 'lissom-site-'));
  #server: Server | undefined;
  #port = 0;

  constructor(built = 'dist') {
    cpSync(built, this.folder, { recursive: true });
  }

  get port(): number {
    return this.#port;
  }

  get address(): string {
    return `http://localhost:${this.#port}/`;
  }

  async start(): Promise<this> {
    const server = createServer((request, response) => this.#answer(request, response));
    await new Promise<void>((listening) => server.listen(this.#port, listening));
    this.#port = (server.address() as AddressInfo).port;
    this.#server = server;
    return this;
  }

  async stop(): Promise<void> {
    const server = this.#server;
    this.#server = undefined;
    if (!server) return;
    const closed = new Promise((done) => server.close(done));
    server.closeAllConnections();
    await closed;
  }

  async end(): Promise<void> {
    await this.stop();
    rmSync(this.folder, { recursive: true, force: true });
  }

  /** What the service worker fetches ahead. */
  get files(): readonly string[] {
    const [, list] = /\/\* build \*\/ (\{.*?\});/.exec(this.read('sw.js'))!;
    const { files } = JSON.parse(list!) as { files: string[] };
    return files.map((file) => (file === './' ? 'index.html' : file));
  }

  /**
   * Another version in place of this one, as a build leaves it: the start page and its script have changed, and with
   * them the names of all files that name one whose name has changed.
   */
  release(name: string): void {
    const page = this.read('index.html');
    const [, entry] = /assets\/(index-[\w-]{8}\.js)/.exec(page)!;
    const texts = readdirSync(path.join(this.folder, 'assets')).filter((file) => /\.(js|css)$/.test(file));
    const changed = new Set([entry!]);
    for (const each of changed)
      for (const file of texts) if (this.read(`assets/${file}`).includes(each)) changed.add(file);
    const renamed = (text: string) =>
      [...changed].reduce((text, file) => text.replaceAll(file, nameIn(name, file)), text);
    for (const file of texts) this.write(`assets/${file}`, renamed(this.read(`assets/${file}`)));
    for (const file of changed)
      renameSync(path.join(this.folder, 'assets', file), path.join(this.folder, 'assets', renamed(file)));
    this.write('index.html', renamed(page).replace(/<head[^>]*>/, `<head data-release="${name}">`));
    writePrecacheList(this.folder, this.files.map(renamed));
  }

  write(file: string, content: string): void {
    writeFileSync(path.join(this.folder, file), content);
  }

  has(file: string): boolean {
    return existsSync(path.join(this.folder, file));
  }

  remove(file: string): void {
    rmSync(path.join(this.folder, file));
  }

  read(file: string): string {
    return readFileSync(path.join(this.folder, file), 'utf8');
  }

  #answer({ url = '/' }: IncomingMessage, response: ServerResponse): void {
    const { pathname } = new URL(url, 'http://localhost');
    const file = pathname.endsWith('/') ? `${pathname}index.html` : pathname;
    try {
      const content = readFileSync(path.join(this.folder, path.posix.normalize(file)));
      const type = TYPES[path.extname(file)] ?? 'application/octet-stream';
      response.writeHead(200, { 'Content-Type': type, 'Cache-Control': 'no-cache' }).end(content);
    } catch {
      response.writeHead(404).end();
    }
  }
}
