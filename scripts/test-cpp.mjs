// The kernel's own tests, natively. Usage: node scripts/test-cpp.mjs [--sanitize] [doctest arguments]

import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { nativeBuild } from './lib/cmake.mjs';
import { run } from './lib/run.mjs';
import { root } from './lib/system.mjs';

/** @returns the test program. @throws if it cannot be built */
export async function buildTests(sanitize) {
  const folder = path.join(root, 'build', sanitize ? 'sanitize' : 'native');
  // Eigen's own assertions are on only without NDEBUG, hence Debug under the sanitizers.
  const settings = sanitize ? ['-DCMAKE_BUILD_TYPE=Debug', '-DLISSOM_SANITIZE=ON'] : [];
  await nativeBuild(folder, 'lissom_tests', { settings });
  return path.join(folder, 'lissom_tests');
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  try {
    const program = await buildTests(process.argv.includes('--sanitize'));
    process.exitCode = await run(
      program,
      process.argv.slice(2).filter((arg) => arg !== '--sanitize'),
    );
  } catch (error) {
    console.error(error.message);
    process.exitCode = 1;
  }
}
