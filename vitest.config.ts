import { defineConfig } from 'vitest/config';

export default defineConfig({
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  test: {
    include: ['tests/**/*.test.{ts,tsx}'],
    exclude: ['tests/e2e/**', 'tests/wasm/**'],
    maxWorkers: '100%', // left to itself it leaves one core of two idle
    // The kernel's own tests may run beside these, on the same cores: nothing here is about speed.
    testTimeout: 120_000,
    hookTimeout: 120_000,
  },
});
