import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import path from 'node:path';
import { must } from './run.mjs';
import { onPath, root } from './system.mjs';

/**
 * Configures wasm/ in `folder` if need be and builds `target` there, incrementally. Starts afresh when the
 * settings or the compiler are not those that the folder was made with. @throws if it fails
 */
export async function cmakeBuild(folder, target, { env = process.env, settings = [], compiler = '' } = {}) {
  const args = ['-DCMAKE_BUILD_TYPE=Release', ...settings];
  const stamp = path.join(folder, 'configured-with');
  const configured = [compiler, ...args].join('\n');
  if (!existsSync(stamp) || readFileSync(stamp, 'utf8') !== configured) {
    rmSync(folder, { recursive: true, force: true });
    mkdirSync(folder, { recursive: true });
    const generator = onPath('ninja') ? ['-G', 'Ninja'] : [];
    await must('cmake', ['-S', path.join(root, 'wasm'), '-B', folder, ...generator, ...args], { env });
    writeFileSync(stamp, configured);
  }
  const parallel = ['--parallel', String(availableParallelism())];
  await must('cmake', ['--build', folder, '--target', target, ...parallel], { env });
}

/** `cmakeBuild` with the system's own compiler, and with ccache where there is one. @throws if it fails */
export async function nativeBuild(folder, target, { settings = [] } = {}) {
  if (!onPath('ccache')) return cmakeBuild(folder, target, { settings });
  // Without these ccache keeps nothing that was compiled with a precompiled header.
  const own = process.env.CCACHE_SLOPPINESS ?? '';
  const env = { ...process.env, CCACHE_SLOPPINESS: `${own},pch_defines,time_macros`.replace(/^,/, '') };
  return cmakeBuild(folder, target, { env, settings: [...settings, '-DCMAKE_CXX_COMPILER_LAUNCHER=ccache'] });
}
