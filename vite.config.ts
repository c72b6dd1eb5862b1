import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { licences } from './scripts/licences-plugin.ts';
import { precache } from './scripts/precache-plugin.ts';

const { version } = JSON.parse(readFileSync(new URL('./package.json', import.meta.url), 'utf8'));
const jsx = { runtime: 'automatic', importSource: 'preact' } as const;
const { plugin, forWorkers } = licences(fileURLToPath(new URL('.', import.meta.url)));

/** What the first picture needs beside the built files. */
const FIRST = [
  'manifest.webmanifest',
  'icons/lissom.svg',
  'gallery/index.json',
  'gallery/recipes/first.json',
  'gallery/dinosaur.ply',
];

export default defineConfig({
  root: 'web',
  publicDir: '../public',
  base: './',
  define: { __VERSION__: JSON.stringify(version) },
  plugins: [plugin, precache(FIRST)],
  oxc: { jsx },
  optimizeDeps: { rolldownOptions: { transform: { jsx } } }, // the scan for dependencies does not read `oxc`
  build: { outDir: '../dist', emptyOutDir: true, target: 'es2022', chunkSizeWarningLimit: 1000 },
  worker: { format: 'es', plugins: forWorkers },
  server: { fs: { allow: ['..'] } },
});
