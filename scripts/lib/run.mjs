import { spawn } from 'node:child_process';
import path from 'node:path';
import { root } from './system.mjs';

/** Runs a program in the repository's root, its output shown as it comes. @returns its exit code */
export async function run(program, args, options = {}) {
  return (await ended(spawn(program, args, { cwd: root, stdio: 'inherit', ...options }))).status;
}

/** The same; @throws if it fails */
export async function must(program, args, options) {
  const status = await run(program, args, options);
  if (status !== 0) throw new Error(`${path.basename(program)} ${args.join(' ')} ended with code ${status}.`);
}

/** Runs a program without showing what it says. @returns its exit code and its output */
export async function record(program, args) {
  const child = spawn(program, args, { cwd: root, stdio: ['ignore', 'pipe', 'pipe'] });
  let output = '';
  for (const stream of [child.stdout, child.stderr])
    stream.setEncoding('utf8').on('data', (text) => {
      output += text;
    });
  const { status, problem } = await ended(child);
  return { status, output: output + problem };
}

/** A program that cannot be started ends with code 1. */
function ended(child) {
  return new Promise((resolve) => {
    child.on('error', ({ message }) => {
      if (!child.stdout) console.error(message);
      resolve({ status: 1, problem: message });
    });
    child.on('close', (status) => resolve({ status: status ?? 1, problem: '' }));
  });
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
