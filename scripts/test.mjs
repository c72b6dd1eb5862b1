import { layers, runLayer } from './lib/layers.mjs';
import { say } from './lib/say.mjs';

/** Runs the layers (all, or those named), ends with the line `N passed, N failed`. @returns an exit code */
export function runTests(names = []) {
  const chosen = layers.filter(({ name }) => names.length === 0 || names.includes(name));
  const results = chosen.map((layer) => {
    say(`Testing: ${layer.name}`);
    const started = performance.now();
    const counts = runLayer(layer);
    return { name: layer.name, seconds: (performance.now() - started) / 1000, ...counts };
  });
  const total = (key) => results.reduce((sum, result) => sum + result[key], 0);

  say('Summary');
  for (const result of results)
    console.log(
      `${result.name.padEnd(22)}${line(result).padEnd(36)}${result.seconds.toFixed(0).padStart(5)} s`,
    );
  const all = { passed: total('passed'), failed: total('failed'), skipped: total('skipped') };
  console.log(`\n${line(all)}`);
  return all.failed === 0 ? 0 : 1;
}

const line = ({ passed, failed, skipped }) =>
  `${passed} passed, ${failed} failed${skipped > 0 ? `, ${skipped} skipped` : ''}`;
