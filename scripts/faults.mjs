// Ends pages, workers, databases and storage at random moments of random edits in a real browser, and looks whether
// the last edit is there again.
//
//   npm run faults [count] [seed]   200 faults from seed 0 when left out; `1 123` is that of seed 123 again

import { buildProducts } from './build.mjs';
import { run, tool } from './lib/run.mjs';

const [count = 200, from = 0] = process.argv.slice(2).map(Number);
if (!(Number.isInteger(count) && count > 0 && Number.isInteger(from) && from >= 0)) {
  console.error('How it is called: npm run faults -- [count] [seed]');
  process.exitCode = 1;
} else {
  await buildProducts({ types: false });
  const env = { ...process.env, LISSOM_FAULTS: String(count), LISSOM_FAULTS_FROM: String(from) };
  const files = ['tests/e2e/faults.spec.ts', '--grep', 'random edits', '--reporter=list'];
  process.exitCode = await run(process.execPath, tool('playwright', 'test', ...files), { env });
}
