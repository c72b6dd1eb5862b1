// The layers of the test suite, each run to its end whatever became of the others, and counted.

import { existsSync, mkdirSync, readFileSync, rmSync } from 'node:fs';
import path from 'node:path';
import { buildProducts } from '../build.mjs';
import { buildTests } from '../test-cpp.mjs';
import { buildKernel } from '../wasm.mjs';
import { record, run, tool } from './run.mjs';
import { root } from './system.mjs';

const reports = path.join(root, 'build/reports');
const node = process.execPath;

export const layers = [
  { name: 'lint', run: () => check(run(node, tool('biome', 'ci', '.'))) },
  { name: 'types', run: () => check(run(node, tool('tsc', '-p', '.'))) },
  { name: 'kernel', run: kernel },
  { name: 'C++', run: () => doctest(false) },
  { name: 'C++ under sanitizers', run: () => doctest(true) },
  { name: 'units', run: vitest },
  { name: 'products', run: products },
  { name: 'browser', run: playwright },
];

/** @returns counts; a layer that ends badly without a count is one failure */
export function runLayer(layer) {
  try {
    return layer.run();
  } catch (error) {
    console.error(error.message);
    return { passed: 0, failed: 1, skipped: 0 };
  }
}

const check = (status) => ({ passed: status === 0 ? 1 : 0, failed: status === 0 ? 0 : 1, skipped: 0 });

const settled = (status, { passed, failed, skipped }) => ({
  passed,
  failed: status !== 0 && failed === 0 ? 1 : failed,
  skipped,
});

function kernel() {
  buildKernel();
  return check(0);
}

function doctest(sanitize) {
  const program = buildTests(sanitize);
  const { status, output } = record(program, []);
  const counts = output.match(/test cases:\s*\d+ \|\s*(\d+) passed \|\s*(\d+) failed \|\s*(\d+) skipped/);
  const [passed = 0, failed = 0, skipped = 0] = counts?.slice(1).map(Number) ?? [];
  return settled(counts ? status : 1, { passed, failed, skipped });
}

function vitest() {
  const file = fresh('vitest.json');
  const reporters = ['--reporter=default', '--reporter=json', `--outputFile.json=${file}`];
  const status = run(node, tool('vitest', 'run', ...reporters));
  const { numPassedTests, numFailedTests, numPendingTests, numTodoTests } = read(file);
  return settled(status, {
    passed: numPassedTests,
    failed: numFailedTests,
    skipped: numPendingTests + numTodoTests,
  });
}

function products() {
  buildProducts({ types: false }); // that is a layer of its own
  return check(run(node, ['dist-cli/lissom.mjs', '--version']));
}

function playwright() {
  const file = fresh('playwright.json');
  const env = { ...process.env, PLAYWRIGHT_JSON_OUTPUT_NAME: file };
  const status = run(node, tool('playwright', 'test', '--reporter=list,json'), { env });
  const { expected, unexpected, flaky, skipped } = read(file).stats;
  return settled(status, { passed: expected + flaky, failed: unexpected, skipped });
}

function fresh(name) {
  const file = path.join(reports, name);
  mkdirSync(reports, { recursive: true });
  rmSync(file, { force: true });
  return file;
}

function read(file) {
  if (!existsSync(file)) throw new Error('The tests ended without a report.');
  return JSON.parse(readFileSync(file, 'utf8'));
}
