import { begin, layers } from './lib/layers.mjs';
import { say } from './lib/say.mjs';

/** Runs the layers (all, or those named), ends with the line `N passed, N failed`. @returns an exit code */
export async function runTests(names = [], all = layers) {
  const started = performance.now();
  const chosen = all.filter(({ name }) => names.length === 0 || names.includes(name));
  const begun = [];
  const untold = [];
  /** What went on beside other layers is told between two of them, whole. */
  const tell = () => {
    for (const { name, output } of untold.splice(0)) {
      say(`Tested: ${name}`);
      process.stdout.write(output);
    }
  };
  for (const layer of chosen) {
    say(`Testing: ${layer.name}`);
    const { over } = await begin(layer);
    begun.push(over);
    over.then((result) => result.output && untold.push(result));
    if (layer.beside)
      console.log('Its tests run beside what follows; what they say is told when they are over.');
    tell();
  }
  const results = await Promise.all(begun);
  tell();

  say('Summary');
  const seconds = (number) => `${number.toFixed(0).padStart(5)} s`;
  for (const result of results)
    console.log(`${result.name.padEnd(22)}${line(result).padEnd(36)}${seconds(result.seconds)}`);
  const total = (key) => results.reduce((count, result) => count + result[key], 0);
  const sum = { passed: total('passed'), failed: total('failed'), skipped: total('skipped') };
  console.log(`${'all, some side by side'.padEnd(58)}${seconds((performance.now() - started) / 1000)}`);
  console.log(`\n${line(sum)}`);
  return sum.failed === 0 ? 0 : 1;
}

const line = ({ passed, failed, skipped }) =>
  `${passed} passed, ${failed} failed${skipped > 0 ? `, ${skipped} skipped` : ''}`;
