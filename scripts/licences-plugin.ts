// Writes `licences.txt` beside a build: the licence of everything in it, found by the modules that went in.

import { existsSync, readdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import type { Plugin } from 'vite';

interface Part {
  readonly name: string;
  readonly licence: string;
  readonly source: string;
  readonly text: string;
}

interface Package {
  readonly name: string;
  readonly version: string;
  readonly license?: string;
  readonly homepage?: string;
  readonly dependencies?: Readonly<Record<string, string>>;
}

const FILE = 'licences.txt';
const RULE = '='.repeat(80);

export interface Licences {
  readonly plugin: Plugin;
  /** Workers are bundled apart from what starts them: for `worker.plugins`. */
  readonly forWorkers: () => Plugin[];
}

/** @param root  the repository: its own licence, and those of what is compiled into the kernel */
export function licences(root: string): Licences {
  const found = new Map<string, Part>();
  const collect: Plugin['generateBundle'] = function (_options, bundle) {
    for (const chunk of Object.values(bundle)) {
      if (chunk.type !== 'chunk') continue;
      for (const id of chunk.moduleIds) {
        const folder = packageFolder(id);
        if (!folder || found.has(folder)) continue;
        const part = partOf(folder);
        if (!part.licence) this.error(`${part.name} is bundled, but its package names no licence.`);
        found.set(folder, part);
      }
    }
  };
  return {
    plugin: {
      name: 'lissom:licences',
      generateBundle(options, bundle, isWrite) {
        collect.call(this, options, bundle, isWrite);
        this.emitFile({ type: 'asset', fileName: FILE, source: listOf(root, [...found.values()]) });
      },
      // Nothing is bundled then: what may be.
      configureServer({ middlewares }) {
        middlewares.use(`/${FILE}`, (_request, response) => {
          response.setHeader('Content-Type', 'text/plain; charset=utf-8');
          response.end(listOf(root, [...installed(root)].map(partOf)));
        });
      },
    },
    forWorkers: () => [{ name: 'lissom:licences-of-workers', generateBundle: collect }],
  };
}

/** Where the package that a module is part of lies; `null` for a module of our own. */
function packageFolder(id: string): string | null {
  const file = id.replace(/^\0/, '').replace(/\?.*$/s, '');
  if (!file.includes('/node_modules/')) return null;
  let folder = path.dirname(file);
  // Packages have further package.json files inside, which only say what kind of modules lie there.
  while (!isPackage(folder)) {
    const parent = path.dirname(folder);
    if (parent === folder || path.basename(folder) === 'node_modules') return null;
    folder = parent;
  }
  return folder;
}

function isPackage(folder: string): boolean {
  if (!existsSync(path.join(folder, 'package.json'))) return false;
  const { name, version } = readPackage(folder) as Partial<Package>;
  return name !== undefined && version !== undefined;
}

const readPackage = (folder: string): Package =>
  JSON.parse(readFileSync(path.join(folder, 'package.json'), 'utf8')) as Package;

/** Folders of the packages that one asks for, and of those that these ask for. */
function installed(root: string, from = root, found = new Set<string>()): Set<string> {
  for (const name of Object.keys(readPackage(from).dependencies ?? {})) {
    const places = [from, root].map((folder) => path.join(folder, 'node_modules', name));
    const folder = places.find((place) => existsSync(place));
    if (!folder || found.has(folder)) continue;
    found.add(folder);
    installed(root, folder, found);
  }
  return found;
}

function partOf(folder: string): Part {
  const read = readPackage(folder);
  const texts = readdirSync(folder).filter((file) => /^(licen[cs]e|copying|notice)/i.test(file));
  return {
    name: `${read.name} ${read.version}`,
    licence: read.license ?? '',
    source: read.homepage ?? `https://www.npmjs.com/package/${read.name}`,
    text: texts.map((file) => readFileSync(path.join(folder, file), 'utf8').trim()).join('\n\n'),
  };
}

/** What the C++ compiler puts into the kernel, which no bundler sees. */
function kernelParts(root: string): Part[] {
  const folder = path.join(root, 'licences');
  const parts = JSON.parse(readFileSync(path.join(folder, 'kernel.json'), 'utf8')) as Part[];
  return parts.map((part) => ({
    ...part,
    text: readFileSync(path.join(folder, part.text), 'utf8').trim(),
  }));
}

function listOf(root: string, packages: readonly Part[]): string {
  const sorted = [...packages].sort((a, b) => (a.name < b.name ? -1 : 1));
  const parts = [...sorted, ...kernelParts(root)];
  const own = readFileSync(path.join(root, 'LICENSE'), 'utf8').trim();
  const contents = parts.map(({ name, licence }) => `  ${name} (${licence})`).join('\n');
  const texts = parts.map(({ name, licence, source, text }) => `${name} (${licence})\n${source}\n\n${text}`);
  return `${[`Lissom\n\n${own}`, `It contains:\n\n${contents}`, ...texts].join(`\n\n${RULE}\n\n`)}\n`;
}
