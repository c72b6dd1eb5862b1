// Measures the kernel's algorithms beside Eigen's, compiled the same way, and prints a table per program.

import { readdirSync } from 'node:fs';
import path from 'node:path';
import { nativeBuild } from './lib/cmake.mjs';
import { record } from './lib/run.mjs';
import { announced, say } from './lib/say.mjs';
import { root } from './lib/system.mjs';
import { buildWithEmscripten } from './wasm.mjs';

/**
 * WebAssembly under Node; with `--native` natively too. Other arguments go to the programs
 * (`--vertices 10000,50000`). @returns an exit code
 */
export async function runBenchmarks(args) {
  const programs = readdirSync(path.join(root, 'tests/bench/cpp'))
    .filter((name) => name.endsWith('_bench.cpp'))
    .map((name) => path.basename(name, '.cpp'));
  const rest = args.filter((arg) => arg !== '--native');
  await announced('Building the benchmarks', () => buildWithEmscripten('benches'));
  const wasm = (name) => [process.execPath, path.join(root, 'build/wasm', `${name}.cjs`)];
  const failures = await measure('WebAssembly', programs, wasm, rest);
  if (!args.includes('--native')) return failures;
  const folder = path.join(root, 'build/native');
  await announced('Building them natively', () => nativeBuild(folder, 'benches'));
  return failures + (await measure('native', programs, (name) => [path.join(folder, name)], rest));
}

async function measure(flavour, programs, command, args) {
  let failures = 0;
  for (const name of programs) {
    say(`${name}, ${flavour}`);
    const [program, ...before] = command(name);
    const { status, output } = await record(program, [...before, ...args]);
    const rows = output.split('\n').filter((line) => line.startsWith('{'));
    if (status !== 0 || rows.length === 0) {
      console.error(output);
      failures++;
    } else console.log(table(rows.map((row) => JSON.parse(row))));
  }
  return failures;
}

/** Rows of one JSON object each as a text table; columns in the order they first appear. */
function table(rows) {
  const columns = [...new Set(rows.flatMap((row) => Object.keys(row)))];
  const cells = [columns, ...rows.map((row) => columns.map((column) => String(row[column] ?? '')))];
  const widths = columns.map((_, i) => Math.max(...cells.map((line) => line[i].length)));
  return cells.map((line) => line.map((cell, i) => cell.padStart(widths[i])).join('  ')).join('\n');
}
