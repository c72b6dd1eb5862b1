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

/**
 * Figures of whole models take the sanitizers half an hour, and run nothing that smaller ones do not. So do whole matches,
 * wraps and tracked curves, tens of fits and crossing tests each: their parts have tests of their own.
 */
const SMALL = [
  `--source-file-exclude=${['quality', 'match_session', 'outer_surface', 'pairwise_match', 'sharp_tracking', 'wrap'].map((stem) => `*${stem}_test.cpp`).join(',')}`,
];

/**
 * In the order they are begun. A layer that keeps only one core busy says so with `beside`: once it is built, what
 * comes after it is begun too. The sanitizers' tests take longest, so they begin first.
 */
export const layers = [
  { name: 'lint', run: async () => check(await run(node, tool('biome', 'ci', '.'))) },
  { name: 'types', run: async () => check(await run(node, tool('tsc', '-p', '.'))) },
  { name: 'kernel', run: kernel },
  {
    name: 'C++ under sanitizers',
    build: () => buildTests(true),
    beside: (program) => doctest(program, SMALL),
  },
  { name: 'C++', build: () => buildTests(false), beside: doctest },
  { name: 'units', run: vitest },
  { name: 'products', run: products },
  { name: 'browser', run: playwright },
];

/**
 * Begins a layer and waits until the next one may begin.
 *
 * @returns `over`, a promise of counts, seconds and, for a layer that went on beside others, its output. A layer that
 *   ends badly without a count is one failure
 */
export async function begin({ name, run, build, beside }) {
  const started = performance.now();
  const outcome = (counts) => ({ name, seconds: (performance.now() - started) / 1000, ...counts });
  const failure = ({ message }) => outcome({ passed: 0, failed: 1, skipped: 0, output: `${message}\n` });
  try {
    if (!beside) return { over: Promise.resolve(outcome(await run())) };
    return { over: beside(await build()).then(outcome, failure) };
  } catch (error) {
    return { over: Promise.resolve(failure(error)) };
  }
}

const check = (status) => ({ passed: status === 0 ? 1 : 0, failed: status === 0 ? 0 : 1, skipped: 0 });

const settled = (status, { passed, failed, skipped }) => ({
  passed,
  failed: status !== 0 && failed === 0 ? 1 : failed,
  skipped,
});

async function kernel() {
  await buildKernel();
  return check(0);
}

async function doctest(program, args = []) {
  const { status, output } = await record(program, args);
  const counts = output.match(/test cases:\s*\d+ \|\s*(\d+) passed \|\s*(\d+) failed \|\s*(\d+) skipped/);
  const [passed = 0, failed = 0, skipped = 0] = counts?.slice(1).map(Number) ?? [];
  return { ...settled(counts ? status : 1, { passed, failed, skipped }), output };
}

async function vitest() {
  const file = fresh('vitest.json');
  const reporters = ['--reporter=default', '--reporter=json', `--outputFile.json=${file}`];
  const status = await run(node, tool('vitest', 'run', ...reporters));
  const { numPassedTests, numFailedTests, numPendingTests, numTodoTests } = read(file);
  return settled(status, {
    passed: numPassedTests,
    failed: numFailedTests,
    skipped: numPendingTests + numTodoTests,
  });
}

async function products() {
  await buildProducts({ types: false }); // that is a layer of its own
  return check(await run(node, ['dist-cli/lissom.mjs', '--version']));
}

async function playwright() {
  const file = fresh('playwright.json');
  const env = { ...process.env, PLAYWRIGHT_JSON_OUTPUT_NAME: file };
  const status = await run(node, tool('playwright', 'test', '--reporter=list,json'), { env });
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
