// The thread that makes and feeds the inputs: rounds until the time is over. Where it is stands in memory that the one
// who watches can see, should an input never end.

import { parentPort, workerData } from 'node:worker_threads';
import { openSources } from './sources.mjs';

const { seed, kinds: wanted, from, end, place } = workerData;

const server = await openSources();
const { Fuzzing, generators } = await server.ssrLoadModule('/tests/fuzz/fuzz.ts');
const { Random } = await server.ssrLoadModule('/tests/fuzz/random.ts');
const chosen = generators.filter(({ kind }) => wanted === undefined || wanted.includes(kind));
if (chosen.length === 0)
  throw new Error(`there is no kind ${wanted}; there are ${generators.map((g) => g.kind).join(', ')}`);
const kinds = chosen.map((each) => each.kind);
parentPort.postMessage({ kinds });
const begins = (name, at) => {
  place[1] = kinds.indexOf(name);
  place[2] = at;
  Atomics.add(place, 0, 1);
};
let fuzzing = new Fuzzing(chosen, begins);
let calls = 0;
const report = (last) => {
  const counts = [...fuzzing.counts].map(([name, count]) => [name, count]);
  parentPort.postMessage({ done: { counts, calls: fuzzing.kernelCalls - calls, last } });
  calls = fuzzing.kernelCalls;
  fuzzing = new Fuzzing(chosen, begins);
};
// Who asks for one seed wants to see what was fed, even if it never ends.
if (seed !== undefined)
  for (const each of chosen)
    if (each.show)
      parentPort.postMessage({ shown: `${each.kind}\n${each.show(new Random(seed, each.kind))}` });
const rounds = seed === undefined ? Number.POSITIVE_INFINITY : 1;
for (let i = 0; i < rounds && Date.now() < end; i++) {
  await fuzzing.round(seed ?? from + i, seed !== undefined);
  for (const { error, ...finding } of fuzzing.findings.splice(0))
    parentPort.postMessage({ finding: { ...finding, message: error?.stack ?? String(error) } });
  if (i % 100 === 99) report(false);
}
await server.close();
report(true);
