import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

// The official libraries of USD and Alembic, in a virtual environment under build/ that is made once.

const PACKAGES = ['usd-core==26.11', 'alembic3d==1.8.12.1'];
const FOLDER = fileURLToPath(new URL('../../../build/py-venv/', import.meta.url));
const READY = path.join(FOLDER, 'ready');
const windows = process.platform === 'win32';
const INSIDE = path.join(FOLDER, windows ? 'Scripts/python.exe' : 'bin/python');

export interface Python {
  /** Why there is none; the tests then say so. */
  readonly missing?: string;
  /** What the script, given as text, prints as JSON. */
  run(script: string, args: readonly string[]): unknown;
}

export function findPython(): Python {
  const missing = existsSync(READY) ? undefined : install();
  return { ...(missing !== undefined && { missing }), run };
}

function install(): string | undefined {
  const python = ['python3', 'python'].find((name) => spawnSync(name, ['-c', 'import venv']).status === 0);
  if (!python) return 'no Python';
  mkdirSync(FOLDER, { recursive: true });
  if (spawnSync(python, ['-m', 'venv', '--clear', FOLDER]).status !== 0) return 'Python without venv';
  const pip = [
    '-m',
    'pip',
    'install',
    '--quiet',
    '--disable-pip-version-check',
    '--no-deps',
    '--only-binary=:all:',
  ];
  const limits = ['--retries', '1', '--timeout', '10'];
  if (spawnSync(INSIDE, [...pip, ...limits, ...PACKAGES], { timeout: 50_000 }).status !== 0)
    return `${PACKAGES.join(' and ')} not to be had`;
  writeFileSync(READY, '');
  return undefined;
}

function run(script: string, args: readonly string[]): unknown {
  const { status, stdout, stderr } = spawnSync(INSIDE, ['-c', script, ...args], {
    encoding: 'utf8',
    maxBuffer: 1 << 28,
    timeout: 25_000,
  });
  if (status !== 0) throw new Error(stderr);
  return JSON.parse(stdout);
}
