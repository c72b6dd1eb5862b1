// Makes the products: dist/ (the static site) and dist-cli/lissom.mjs (the command line).

import { chmodSync, copyFileSync } from 'node:fs';
import path from 'node:path';
import { must, tool } from './lib/run.mjs';
import { say } from './lib/say.mjs';
import { root } from './lib/system.mjs';
import { buildKernel } from './wasm.mjs';

/** @throws if one of them cannot be made */
export async function buildProducts({ types = true } = {}) {
  await buildKernel();
  if (types) {
    say('Checking types');
    await must(process.execPath, tool('tsc', '-p', '.'));
  }
  say('Building the site into dist/');
  await must(process.execPath, tool('vite', 'build'));
  say('Building the command line into dist-cli/');
  await must(process.execPath, tool('vite', 'build', '--config', 'vite.cli.config.ts'));
  copyFileSync(path.join(root, 'wasm/dist/kernel.wasm'), path.join(root, 'dist-cli/kernel.wasm'));
  chmodSync(path.join(root, 'dist-cli/lissom.mjs'), 0o755);
}
