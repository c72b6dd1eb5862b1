// Builds wasm/dist/kernel.{mjs,wasm}, only when something under wasm/ or the compiler has changed.
// Usage: node scripts/wasm.mjs [--force]

import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { cmakeBuild } from './lib/cmake.mjs';
import { emscripten } from './lib/emscripten.mjs';
import { fingerprint } from './lib/fingerprint.mjs';
import { withLock } from './lib/lock.mjs';
import { announced } from './lib/say.mjs';
import { root } from './lib/system.mjs';

const dist = path.join(root, 'wasm/dist');
const build = path.join(root, 'build/wasm');
const stamp = path.join(dist, 'built-from');

/** Builds `target` in build/wasm. @throws if it fails */
export async function buildWithEmscripten(target) {
  const { env, toolchain, version } = emscripten();
  const settings = [`-DCMAKE_TOOLCHAIN_FILE=${toolchain}`];
  await cmakeBuild(build, target, { env, settings, compiler: version });
}

/** @returns whether anything had to be built */
export async function buildKernel({ force = false } = {}) {
  const source = () => fingerprint(path.join(root, 'wasm'), ['dist'], emscripten().version);
  const current = () =>
    existsSync(stamp) &&
    existsSync(path.join(dist, 'kernel.wasm')) &&
    readFileSync(stamp, 'utf8') === source();
  if (!force && current()) return false;
  return withLock(path.join(root, 'build/wasm.lock'), async () => {
    if (!force && current()) return false;
    const before = source();
    mkdirSync(dist, { recursive: true });
    const line = existsSync(build)
      ? 'what has changed of it'
      : 'about 3 minutes the first time, on two cores';
    await announced(`Building the kernel (${line})`, () => buildWithEmscripten('kernel'));
    writeFileSync(stamp, before);
    return true;
  });
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  try {
    const built = await buildKernel({ force: process.argv.includes('--force') });
    console.log(built ? 'wasm/dist is built.' : 'wasm/dist is up to date.');
  } catch (error) {
    console.error(error.message);
    process.exitCode = 1;
  }
}
