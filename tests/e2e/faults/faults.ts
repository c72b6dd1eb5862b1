// What can happen to a page: each fault begins at a moment that the trial chooses, and most of them end again.

import type { Page } from '@playwright/test';
import { encodeLink } from '../../../web/recipe/link/link';
import type { Random } from '../../fuzz/random';
import type { Desk } from '../desk';
import { chosen } from './edits';
import { type Victim, workIn } from './victim';

/** What costs little to open. */
const OTHER = encodeLink({ lissom: 1, models: { key: { builtin: 'key' } }, steps: [], outputs: [] });

/** How a page can end. */
export type Death = 'reload' | 'close' | 'crash';

export interface Fault {
  readonly kind: string;
  /** How the page ends at last, or by this alone; of any kind when left out. */
  readonly deaths?: readonly Death[];
  /** The document is only safe once the page says so: nothing else can keep it. */
  readonly onlyOnceSaved?: boolean;
  /** The page ends while it opens, too, some times. */
  readonly whileOpening?: boolean;
  /** False: as on plain http. */
  readonly locks?: boolean;
  /** @returns what ends it */
  begin?(victim: Victim, desk: Desk, random: Random): Promise<Heal>;
}

/** Ends a fault. @throws Error  where it has cost something that only it can tell */
export type Heal = () => Promise<void>;

const nothing: Heal = async () => {};

export const DEATHS: readonly Death[] = ['reload', 'close', 'crash'];
/** Tabs that were opened by one another share a process, which crashes as a whole. */
const NOT_ALL_AT_ONCE: readonly Death[] = ['reload', 'close'];

export const faults: readonly Fault[] = [
  { kind: 'worker killed', begin: (_, { page }) => killWorker(page, true) },
  { kind: 'context lost', begin: (_, { page }) => loseContext(page) },
  { kind: 'quota full', begin: (victim, { page }) => fillQuota(victim, page) },
  { kind: 'tab crashed', deaths: ['crash'] },
  { kind: 'database refuses', begin: (_, { page }, random) => refuse(page, random) },
  { kind: 'reload', deaths: ['reload'] },
  { kind: 'database closed', begin: (_, { page }) => closeDatabases(page) },
  { kind: 'tab closed', deaths: ['close'] },
  { kind: 'journal full', onlyOnceSaved: true, begin: (_, { page }) => fillJournal(page) },
  { kind: 'database blocked', begin: (victim) => blockDatabase(victim) },
  { kind: 'killed while it opens', deaths: ['crash'], whileOpening: true },
  { kind: 'two tabs', deaths: NOT_ALL_AT_ONCE, begin: openTwice },
  { kind: 'two tabs without locks', locks: false, deaths: NOT_ALL_AT_ONCE, begin: openTwice },
  { kind: 'worker vanished', begin: (_, { page }) => killWorker(page, false) },
  { kind: 'database deleted', onlyOnceSaved: true, begin: (victim, { page }) => clear(victim, page) },
];

/** Ends a page as told. @returns once it is gone */
export async function end(page: Page, death: Death): Promise<void> {
  if (death === 'close') await page.close({ runBeforeUnload: false });
  else if (death === 'crash') {
    // Amid a navigation it may be the process of the page before that crashes: then closing ends it.
    const crashed = page.waitForEvent('crash', { timeout: 5000 }).catch(nothing);
    const browser = await page.context().newCDPSession(page);
    browser.send('Page.crash').catch(nothing); // it never answers
    await crashed;
    await page.close();
  } else await page.reload();
}

/** @param said  whether the page hears of it, as it does when a worker crashes */
async function killWorker(page: Page, said: boolean): Promise<Heal> {
  await page.evaluate((told) => {
    const worker = window.__instruments.workers.findLast(Boolean)!;
    worker.terminate();
    if (told) worker.dispatchEvent(new ErrorEvent('error', { message: 'died for a test', cancelable: true }));
  }, said);
  return nothing;
}

async function loseContext(page: Page): Promise<Heal> {
  await page.evaluate(() => {
    const context = document.querySelector('canvas')!.getContext('webgl2')!;
    const lost = context.getExtension('WEBGL_lose_context')!;
    Object.assign(window.__instruments, { restore: () => lost.restoreContext() });
    lost.loseContext();
  });
  return () =>
    page
      .evaluate(() => (window.__instruments as unknown as { restore: () => void }).restore())
      .catch(nothing);
}

/** No byte more for the whole site. */
async function fillQuota({ context }: Victim, page: Page): Promise<Heal> {
  const holder = await context.newPage();
  const browser = await context.newCDPSession(holder);
  const origin = new URL(page.url()).origin;
  await browser.send('Storage.overrideQuotaForOrigin', { origin, quotaSize: 1 });
  return async () => {
    await browser.send('Storage.overrideQuotaForOrigin', { origin });
    await holder.close();
  };
}

async function refuse(page: Page, random: Random): Promise<Heal> {
  const refusal = random.pick(['QuotaExceededError', 'UnknownError', 'DataError', 'ReadOnlyError']);
  const say = (name: string | null) =>
    page.evaluate((refused) => {
      window.__instruments.refusal = refused;
    }, name);
  await say(refusal);
  return () => say(null).catch(nothing); // with the page it went, too
}

/** As a browser does that is short of something: without a word. */
async function closeDatabases(page: Page): Promise<Heal> {
  await page.evaluate(() => {
    for (const database of window.__instruments.databases) database.close();
  });
  return nothing;
}

/** Another tab holds the database, a third waits for a newer version of it: whoever comes later waits behind that. */
async function blockDatabase({ context }: Victim): Promise<Heal> {
  const [holder, waiter] = [await context.newPage(), await context.newPage()];
  await holder.goto('licences.txt');
  await waiter.goto('licences.txt');
  await holder.evaluate(
    () =>
      new Promise((done) => {
        const request = indexedDB.open('lissom', 1);
        request.onsuccess = done;
        Object.assign(window, { request }); // as long as the tab is there
      }),
  );
  await waiter.evaluate(() => {
    Object.assign(window, { request: indexedDB.open('lissom', 2) });
  });
  return async () => {
    await waiter.close();
    await holder.close();
  };
}

/** Another tab opens the same document, and goes on with it while this one does. */
async function openTwice(victim: Victim, desk: Desk, random: Random): Promise<Heal> {
  const other = await victim.duplicate(desk, `?test=1${OTHER}`);
  await other.openEarlier('bar');
  for (let i = 1 + random.below(2); i > 0; i--) await (await chosen(other, random)).make();
  const { recipe } = await workIn(other);
  return async () => {
    const before = await workIn(other);
    if (before.recipe !== recipe) throw new Error('the document changed in the other tab');
    await other.page.reload();
    await other.ready();
    const there = await workIn(other);
    if (there.recipe !== recipe) throw new Error('the other tab lost its last edit');
    await other.page.close();
  };
}

/** Leaves no room in the storage that is written at once. */
async function fillJournal(page: Page): Promise<Heal> {
  await page.evaluate(() => {
    for (let size = 2 ** 22; size >= 1; size = Math.floor(size / 2))
      try {
        for (let i = 0; ; i++) localStorage.setItem(`filling ${size} ${i}`, 'x'.repeat(size));
      } catch {
        // Full for this size: the next one is half of it.
      }
  });
  return nothing;
}

/** A person clears the site's data, as far as databases go, while it is open. */
async function clear({ context }: Victim, page: Page): Promise<Heal> {
  const browser = await context.newCDPSession(page);
  await browser.send('Storage.clearDataForOrigin', {
    origin: new URL(page.url()).origin,
    storageTypes: 'indexeddb',
  });
  return nothing;
}
