import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { licences } from './scripts/licences-plugin.ts';

// The command line as one file that needs nothing beside it but kernel.wasm.
export default defineConfig({
  publicDir: false,
  plugins: [licences(fileURLToPath(new URL('.', import.meta.url))).plugin],
  ssr: { noExternal: true, target: 'node' },
  build: {
    ssr: 'web/cli/main.ts',
    outDir: 'dist-cli',
    emptyOutDir: true,
    target: 'node20',
    rolldownOptions: {
      output: {
        entryFileNames: 'lissom.mjs',
        codeSplitting: false,
        banner: '#!/usr/bin/env node',
      },
    },
  },
});
