import { existsSync } from 'node:fs';
import { defineConfig } from '@playwright/test';

// The system's Chromium where there is one; otherwise Playwright's own.
const chromium = [process.env.CHROMIUM_PATH, '/usr/bin/chromium'].find((file) => file && existsSync(file));
const sandbox = process.getuid?.() === 0 ? ['--no-sandbox'] : [];
const webgl = ['--enable-unsafe-swiftshader', '--use-angle=swiftshader', '--ignore-gpu-blocklist'];
const port = Number(process.env.LISSOM_PREVIEW_PORT ?? 4179);

export default defineConfig({
  testDir: 'tests/e2e',
  outputDir: 'test-results',
  // Files side by side; the tests of one file share a page.
  workers: 2,
  // A browser that draws in software may stall on a busy machine. What fails twice is a fault; what passes at the second
  // try is listed as flaky.
  retries: 1,
  // Software rendering on a busy machine: nothing here is about speed.
  timeout: 180_000,
  expect: { timeout: 30_000 },
  forbidOnly: Boolean(process.env.CI),
  use: {
    baseURL: `http://localhost:${port}/`,
    viewport: { width: 1440, height: 900 },
    launchOptions: { args: [...sandbox, ...webgl], ...(chromium && { executablePath: chromium }) },
  },
  webServer: {
    command: `${JSON.stringify(process.execPath)} node_modules/vite/bin/vite.js preview --port ${port} --strictPort`,
    url: `http://localhost:${port}/`,
    reuseExistingServer: !process.env.CI,
    stdout: 'ignore',
  },
});
