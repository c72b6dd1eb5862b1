import { readFileSync } from 'node:fs';
import { defineConfig } from 'vite';

const { version } = JSON.parse(readFileSync(new URL('./package.json', import.meta.url), 'utf8'));
const jsx = { runtime: 'automatic', importSource: 'preact' } as const;

export default defineConfig({
  root: 'web',
  publicDir: '../public',
  base: './',
  define: { __VERSION__: JSON.stringify(version) },
  oxc: { jsx },
  optimizeDeps: { rolldownOptions: { transform: { jsx } } }, // the scan for dependencies does not read `oxc`
  build: { outDir: '../dist', emptyOutDir: true, target: 'es2022', chunkSizeWarningLimit: 1000 },
  worker: { format: 'es' },
  server: { fs: { allow: ['..'] } },
});
