// A copy of the built site on a server of its own, which can be stopped and whose files can change.

import { cpSync, mkdtempSync, readdirSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
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
    const [, list] = /\/\* build \*\/ (\{.*?\});/.exec(this.#read('sw.js'))!;
    const { files } = JSON.parse(list!) as { files: string[] };
    return files.map((file) => (file === './' ? 'index.html' : file));
  }

  /** Another version in place of this one, as a build leaves it: the start page and its script have changed. */
  release(name: string): void {
    const page = this.#read('index.html');
    const [, script] = /assets\/(index-[\w-]{8}\.js)/.exec(page)!;
    const renamed = `index-${name.padEnd(8, '0').slice(0, 8)}.js`;
    renameSync(path.join(this.folder, 'assets', script!), path.join(this.folder, 'assets', renamed));
    for (const file of [
      'index.html',
      ...readdirSync(path.join(this.folder, 'assets')).map((f) => `assets/${f}`),
    ])
      if (/\.(html|js|css)$/.test(file)) this.write(file, this.#read(file).replaceAll(script!, renamed));
    this.write(
      'index.html',
      this.#read('index.html').replace(/<head[^>]*>/, `<head data-release="${name}">`),
    );
    const files = this.files.map((file) => (file === `assets/${script}` ? `assets/${renamed}` : file));
    writePrecacheList(this.folder, files);
  }

  write(file: string, content: string): void {
    writeFileSync(path.join(this.folder, file), content);
  }

  remove(file: string): void {
    rmSync(path.join(this.folder, file));
  }

  #read(file: string): string {
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
