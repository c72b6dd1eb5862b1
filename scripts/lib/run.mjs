import { spawnSync } from 'node:child_process';
import path from 'node:path';
import { root } from './system.mjs';

/** Runs a program in the repository's root, its output shown as it comes. @returns its exit code */
export function run(program, args, options = {}) {
  const { status, error } = spawnSync(program, args, { cwd: root, stdio: 'inherit', ...options });
  if (error) console.error(error.message);
  return status ?? 1;
}

/** The same; @throws if it fails */
export function must(program, args, options) {
  const status = run(program, args, options);
  if (status !== 0) throw new Error(`${path.basename(program)} ${args.join(' ')} ended with code ${status}.`);
}

/** Runs a program and keeps what it says, showing it too unless `quiet`. */
export function record(program, args, { quiet = false } = {}) {
  const { status, stdout, stderr, error } = spawnSync(program, args, {
    cwd: root,
    encoding: 'utf8',
    maxBuffer: 2 ** 28,
  });
  const output = `${stdout ?? ''}${stderr ?? ''}${error?.message ?? ''}`;
  if (!quiet) process.stdout.write(output);
  return { status: status ?? 1, output };
}

const programs = {
  biome: '@biomejs/biome/bin/biome',
  playwright: '@playwright/test/cli.js',
  tsc: 'typescript/bin/tsc',
  vite: 'vite/bin/vite.js',
  vitest: 'vitest/vitest.mjs',
};

/** A program of node_modules as arguments for this very Node, which may not be the one on PATH. */
export const tool = (name, ...args) => [path.join(root, 'node_modules', programs[name]), ...args];
