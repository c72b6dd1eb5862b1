// Feeds readers, links, recipes and the kernel with damaged inputs, for some minutes or for one seed.
//
//   npm run fuzz [minutes]                    1 minute when left out
//   npm run fuzz -- --seed 123 [--kind link]  one round again, or one kind of it
//   npm run fuzz -- 30 --from 1000            rounds from a seed on, to go on where another machine stopped

import { parseArgs } from 'node:util';
import { Worker } from 'node:worker_threads';

/** Seconds that one input may take before it counts as one that never ends. */
const PATIENCE = 60;
/** Findings that are alike are told once, and counted. */
const MOST_FINDINGS = 20;

async function main() {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: { seed: { type: 'string' }, kind: { type: 'string', multiple: true }, from: { type: 'string' } },
  });
  const minutes = Number(positionals[0] ?? 1);
  const seed = values.seed === undefined ? undefined : Number(values.seed);
  const from = Number(values.from ?? Math.floor(Date.now() / 1000) % 1_000_000_000);
  if (!(minutes > 0) || Number.isNaN(from) || Number.isNaN(seed)) {
    console.error('How it is called: npm run fuzz -- [minutes] [--seed N] [--kind K …] [--from N]');
    return 1;
  }
  const total = new Totals();
  const end = Date.now() + 60_000 * minutes;
  let next = from;
  console.log(
    seed === undefined ? `Rounds from seed ${from}, for ${minutes} min` : `The round of seed ${seed}`,
  );
  while (Date.now() < end) {
    const stopped = await thread({ seed, kinds: values.kind, from: next, end }, total);
    if (stopped === undefined || seed !== undefined) break;
    next = stopped + 1;
  }
  return total.print();
}

/** One thread's share. @returns the seed of the input that never ended, if one did not */
function thread(data, total) {
  const place = new Int32Array(new SharedArrayBuffer(12));
  const worker = new Worker(new URL('./lib/fuzz-thread.mjs', import.meta.url), {
    workerData: { ...data, place },
    resourceLimits: { maxOldGenerationSizeMb: 2048 },
  });
  return new Promise((resolve, reject) => {
    let kinds = [];
    let last = -1;
    let since = Date.now();
    const finish = (seed) => {
      clearInterval(watch);
      void worker.terminate();
      resolve(seed);
    };
    const lost = (message) => {
      total.find({ kind: kinds[place[1]], seed: place[2], message });
      finish(place[2]);
    };
    const watch = setInterval(() => {
      if (place[0] !== last) {
        last = place[0];
        since = Date.now();
      } else if (last > 0 && Date.now() - since > 1000 * PATIENCE) lost(`did not end within ${PATIENCE} s`);
    }, 1000);
    worker.on('message', (message) => {
      if (message.kinds) kinds = message.kinds;
      if (message.shown) console.log(`\n${message.shown}`);
      if (message.finding) total.find(message.finding);
      if (message.done) total.add(message.done);
      if (message.done?.last) finish(undefined);
    });
    worker.on('error', (error) => {
      // Before the first input it is no finding: nothing can be tried.
      if (place[0] > 0) lost(`ended the thread: ${error.message}`);
      else reject(error);
    });
  });
}

/** What all threads have done. */
class Totals {
  counts = new Map();
  calls = 0;
  findings = new Map();
  started = Date.now();

  add({ counts, calls }) {
    this.calls += calls;
    for (const [kind, { inputs, accepted, refused }] of counts) {
      const held = this.counts.get(kind) ?? { inputs: 0, accepted: 0, refused: new Map() };
      held.inputs += inputs;
      held.accepted += accepted;
      for (const [code, n] of refused) held.refused.set(code, (held.refused.get(code) ?? 0) + n);
      this.counts.set(kind, held);
    }
  }

  find({ kind, seed, message }) {
    const key = `${kind} ${message.split('\n')[0].replace(/[\d.e+-]+/g, '#')}`;
    const known = this.findings.get(key);
    this.findings.set(key, { count: (known?.count ?? 0) + 1 });
    if (known || this.findings.size > MOST_FINDINGS) return;
    console.log(`\nFinding in ${kind}, seed ${seed}: ${message.split('\n').slice(0, 8).join('\n  ')}`);
    console.log(`  again: npm run fuzz -- --seed ${seed} --kind '${kind}'`);
  }

  /** @returns an exit code */
  print() {
    let inputs = 0;
    console.log('');
    for (const [kind, held] of [...this.counts].sort()) {
      inputs += held.inputs;
      const codes = [...held.refused].sort((a, b) => b[1] - a[1]).slice(0, 6);
      console.log(
        `${kind.padEnd(12)} ${grouped(held.inputs)} inputs ${grouped(held.accepted)} accepted   ${codes.map(([code, n]) => `${code} ${n}`).join(', ')}`,
      );
    }
    const seconds = Math.round((Date.now() - this.started) / 1000);
    const found = [...this.findings].reduce((sum, [, { count }]) => sum + count, 0);
    console.log(
      `\n${grouped(inputs).trim()} inputs, ${grouped(this.calls).trim()} kernel calls, ${seconds} s, ${found} findings (${this.findings.size} kinds)`,
    );
    return found === 0 ? 0 : 1;
  }
}

const grouped = (n) => n.toLocaleString('en-US').padStart(10);

process.exitCode = await main();
