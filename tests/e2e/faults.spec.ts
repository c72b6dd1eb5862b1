// What a crash may cost a person: nothing. The short run has the same seeds every time; the long one is
// `npm run faults`, which sets how many there are and where they begin.

import { expect, test } from '@playwright/test';
import { profileWithBar, trial } from './faults/trial';

const count = Number(process.env.LISSOM_FAULTS ?? 10);
const from = Number(process.env.LISSOM_FAULTS_FROM ?? 0);

test(`${count} faults at random moments of random edits cost no edit`, async ({ browser, baseURL }) => {
  test.setTimeout(60_000 + 60_000 * count);
  const profile = await profileWithBar(browser, baseURL!);
  const failures: string[] = [];
  const counts = new Map<string, { faults: number; edits: number; lost: number }>();
  for (let seed = from; seed < from + count; seed++) {
    const started = performance.now();
    const { kind, story, edits, lost } = await trial(browser, { baseURL: baseURL!, profile }, seed);
    const sum = counts.get(kind) ?? { faults: 0, edits: 0, lost: 0 };
    counts.set(kind, {
      faults: sum.faults + 1,
      edits: sum.edits + edits,
      lost: sum.lost + (lost.length > 0 ? 1 : 0),
    });
    console.log(
      `${seed} ${kind} (${((performance.now() - started) / 1000).toFixed(1)} s): ${story.join(', ')}`,
    );
    if (lost.length > 0) {
      failures.push(`seed ${seed}, ${kind} (${story.join(', ')}): ${lost.join('\n')}`);
      console.log(failures.at(-1));
    }
  }
  for (const [kind, { faults, edits, lost }] of counts)
    console.log(`${kind.padEnd(24)} ${faults} faults, ${edits} edits, ${lost} lost`);
  expect(failures).toEqual([]);
});
