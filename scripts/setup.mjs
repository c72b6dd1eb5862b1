// One door for everything: installs what is missing, then starts, tests, builds or measures.
// Usage: node scripts/setup.mjs start | test [layer …] | build | bench. Needs Node and npm, nothing else.

import { checkNode, installBuildTools, installNpmPackages, installTestTools } from './lib/install.mjs';
import { run, tool } from './lib/run.mjs';
import { say } from './lib/say.mjs';

const [verb, ...rest] = process.argv.slice(2);

const verbs = {
  async start() {
    const { buildKernel } = await import('./wasm.mjs');
    await buildKernel();
    say('Starting the app; stop it with Ctrl+C');
    return run(process.execPath, tool('vite', ...rest));
  },

  async test() {
    await installTestTools();
    const { runTests } = await import('./test.mjs');
    return runTests(rest);
  },

  async build() {
    const { buildProducts } = await import('./build.mjs');
    await buildProducts();
    return 0;
  },

  async bench() {
    const { runBenchmarks } = await import('./bench.mjs');
    return runBenchmarks(rest);
  },
};

try {
  const chosen = verbs[verb];
  if (!chosen) throw new Error('Usage: node scripts/setup.mjs start | test [layer …] | build | bench');
  checkNode();
  await installNpmPackages();
  await installBuildTools();
  process.exitCode = await chosen();
} catch (error) {
  console.error(`\n${error.message}`);
  process.exitCode = 1;
}
