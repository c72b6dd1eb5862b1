import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import path from 'node:path';
import { must } from './run.mjs';
import { onPath, root } from './system.mjs';

/**
 * Configures wasm/ in `folder` if need be and builds `target` there, incrementally. Starts afresh when the
 * settings or the compiler are not those that the folder was made with. @throws if it fails
 */
export function cmakeBuild(folder, target, { env = process.env, settings = [], compiler = '' } = {}) {
  const args = ['-DCMAKE_BUILD_TYPE=Release', ...settings];
  const stamp = path.join(folder, 'configured-with');
  const configured = [compiler, ...args].join('\n');
  if (!existsSync(stamp) || readFileSync(stamp, 'utf8') !== configured) {
    rmSync(folder, { recursive: true, force: true });
    mkdirSync(folder, { recursive: true });
    const generator = onPath('ninja') ? ['-G', 'Ninja'] : [];
    must('cmake', ['-S', path.join(root, 'wasm'), '-B', folder, ...generator, ...args], { env });
    writeFileSync(stamp, configured);
  }
  must('cmake', ['--build', folder, '--target', target, '--parallel', String(availableParallelism())], {
    env,
  });
}
