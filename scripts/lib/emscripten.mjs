import { existsSync, readFileSync, realpathSync } from 'node:fs';
import path from 'node:path';
import { onPath, root } from './system.mjs';

/** Folder of emcc: that of EMSDK if set, else of the emcc on PATH; undefined if there is none. */
export function emscriptenFolder() {
  const sdk = process.env.EMSDK && path.join(process.env.EMSDK, 'upstream/emscripten');
  if (sdk && existsSync(sdk)) return sdk;
  const emcc = onPath('emcc');
  return emcc && path.dirname(realpathSync(emcc));
}

/** @returns version, CMake toolchain file and the environment that emcc needs. @throws if there is no Emscripten */
export function emscripten() {
  const folder = emscriptenFolder();
  if (!folder) throw new Error('Emscripten is missing: run `npm start` once, or set EMSDK.');
  const version = readFileSync(path.join(folder, 'emscripten-version.txt'), 'utf8')
    .replaceAll('"', '')
    .trim();
  // Debian's emcc looks for acorn where only Debian's own Node would find it.
  const acorn = [path.join(root, 'node_modules'), '/usr/share/nodejs'].find((at) =>
    existsSync(path.join(at, 'acorn')),
  );
  const env = { ...process.env, ...(acorn && { NODE_PATH: acorn }) };
  return { version, toolchain: path.join(folder, 'cmake/Modules/Platform/Emscripten.cmake'), env };
}
