// Installs what is missing and nothing else. Knows npm and Debian's packages; elsewhere it says what to get.

import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { emscriptenFolder } from './emscripten.mjs';
import { must, run, tool } from './run.mjs';
import { announced } from './say.mjs';
import { chromium, onPath, root } from './system.mjs';

const header = (name) =>
  ['/usr/include', '/usr/local/include', '/opt/homebrew/include', '/opt/local/include'].some((folder) =>
    existsSync(path.join(folder, name)),
  );

const building = [
  { name: 'Emscripten (emcc on PATH, or EMSDK set)', debian: 'emscripten', found: emscriptenFolder },
  { name: 'CMake', debian: 'cmake', found: () => onPath('cmake') },
  { name: 'Ninja', debian: 'ninja-build', found: () => onPath('ninja') || onPath('make') },
  {
    name: 'Eigen 3.4',
    debian: 'libeigen3-dev',
    found: () => header('eigen3/Eigen/Core') || header('Eigen/Core'),
  },
];
const testing = [
  { name: 'a C++20 compiler', debian: 'g++', found: () => onPath('g++') || onPath('clang++') },
  { name: 'doctest', debian: 'doctest-dev', found: () => header('doctest/doctest.h') },
];
const browser = { name: 'Chromium', debian: 'chromium', found: chromium };

/** @throws if this Node is too old for the tools */
export function checkNode() {
  const [major, minor] = process.versions.node.split('.').map(Number);
  if (major < 20 || (major === 20 && minor < 19))
    throw new Error(`Node ${process.versions.node} is too old: install Node 20.19 or newer.`);
}

/** `npm ci`, unless node_modules holds what the lock file asks for. */
export async function installNpmPackages() {
  if (packagesMatchLock()) return;
  const shell = process.platform === 'win32';
  await announced('Installing npm packages (about half a minute)', () =>
    must('npm', ['ci', '--no-audit', '--no-fund'], { shell }),
  );
}

function packagesMatchLock() {
  const installed = path.join(root, 'node_modules/.package-lock.json');
  if (!existsSync(installed)) return false;
  const packages = (file) => JSON.parse(readFileSync(file, 'utf8')).packages;
  const have = packages(installed);
  return Object.entries(packages(path.join(root, 'package-lock.json'))).every(
    ([at, { version, optional }]) => at === '' || have[at]?.version === version || (optional && !have[at]),
  );
}

/** Compilers and libraries to build with. @throws with one line that says what to install */
export const installBuildTools = () => install(building);

/** What the tests need beside that. */
export async function installTestTools() {
  if (apt() || browser.found()) return install([...testing, browser]);
  await install(testing);
  await announced('Installing a browser for the tests (about a minute)', () =>
    must(process.execPath, tool('playwright', 'install', 'chromium')),
  );
}

let listsRefreshed = false;

async function install(wanted) {
  const missing = wanted.filter(({ found }) => !found());
  if (missing.length === 0) return;
  const names = missing.map(({ name }) => name).join(', ');
  const become = apt();
  if (!become) throw new Error(`Please install: ${names}. Then run this again.`);
  const [program, ...before] = [...become, 'apt-get'];
  const env = { ...process.env, DEBIAN_FRONTEND: 'noninteractive' };
  const packages = missing.map(({ debian }) => debian);
  const load = [...before, 'install', '-y', '-q', '--no-install-recommends', ...packages];
  await announced(`Installing ${names} (a minute or two)`, async () => {
    listsRefreshed ||= (await run(program, [...before, 'update', '-q'], { env })) === 0;
    if (!listsRefreshed) console.warn('The package lists could not be refreshed; trying with those at hand.');
    await must(program, load, { env });
  });
}

/** How to become root for apt-get, as the start of a command line; undefined where that is not the way. */
function apt() {
  if (!onPath('apt-get')) return undefined;
  if (process.getuid?.() === 0) return [];
  if (!onPath('sudo')) return undefined;
  return process.stdin.isTTY ? ['sudo'] : ['sudo', '-n'];
}
