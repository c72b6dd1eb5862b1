// Builds wasm/dist/kernel.{mjs,wasm}, only when something under wasm/ or the compiler has changed.
// Usage: node scripts/wasm.mjs [--force]

import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { emscripten } from './lib/emscripten.mjs';
import { fingerprint } from './lib/fingerprint.mjs';
import { withLock } from './lib/lock.mjs';
import { onPath, root } from './lib/system.mjs';

const dist = path.join(root, 'wasm/dist');
const build = path.join(root, 'build/wasm');
const stamp = path.join(dist, 'built-from');

/** Configures build/wasm if need be and builds `target` there. @throws if it fails */
export function buildWithEmscripten(target) {
  const { env, toolchain } = emscripten();
  const run = (args) => {
    const { status } = spawnSync('cmake', args, { cwd: root, env, stdio: 'inherit' });
    if (status !== 0) throw new Error(`cmake ${args.join(' ')} failed`);
  };
  if (!existsSync(path.join(build, 'CMakeCache.txt'))) {
    const generator = onPath('ninja') ? ['-G', 'Ninja'] : [];
    run([
      '-S',
      'wasm',
      '-B',
      build,
      ...generator,
      `-DCMAKE_TOOLCHAIN_FILE=${toolchain}`,
      '-DCMAKE_BUILD_TYPE=Release',
    ]);
  }
  run(['--build', build, '--target', target, '--parallel', String(availableParallelism())]);
}

/** @returns whether anything had to be built */
export function buildKernel({ force = false } = {}) {
  const source = () => fingerprint(path.join(root, 'wasm'), ['dist'], emscripten().version);
  const current = () =>
    existsSync(stamp) &&
    existsSync(path.join(dist, 'kernel.wasm')) &&
    readFileSync(stamp, 'utf8') === source();
  if (!force && current()) return false;
  return withLock(path.join(root, 'build/wasm.lock'), () => {
    if (!force && current()) return false;
    const before = source();
    mkdirSync(dist, { recursive: true });
    buildWithEmscripten('kernel');
    writeFileSync(stamp, before);
    return true;
  });
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  try {
    const built = buildKernel({ force: process.argv.includes('--force') });
    console.log(built ? 'wasm/dist is built.' : 'wasm/dist is up to date.');
  } catch (error) {
    console.error(error.message);
    process.exitCode = 1;
  }
}
