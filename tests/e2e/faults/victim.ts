// Someone at work in a browser profile of their own, to whom things happen. Every committed recipe is told to the
// test at once, so that it knows what must be there again whatever becomes of the page.

import type { Browser, BrowserContext, Page } from '@playwright/test';
import { Desk, withoutPickers } from '../desk';

/** What a browser profile holds. */
export type Profile = Awaited<ReturnType<BrowserContext['storageState']>>;

/** The document of a page as it is now. */
export interface Work {
  readonly load: string;
  readonly recipe: string;
  readonly saved: string;
  /** `null` where nothing could be computed. */
  readonly positions: Float64Array | null;
}

interface Instruments {
  /** A name for this page until it ends or is reloaded. */
  readonly load: string;
  /** Every worker that the page has started. */
  readonly workers: Worker[];
  /** Every connection to a database that it has opened. */
  readonly databases: IDBDatabase[];
  /** What each writing into a database throws; `null` for none. */
  refusal: string | null;
}

declare global {
  interface Window {
    readonly __instruments: Instruments;
    readonly __committed: (load: string, recipe: string) => void;
  }
}

/** Small: software rendering pays by the pixel, and nobody looks at these pictures. */
const SIZE = { width: 920, height: 440 };

/** A desk that waits for what is computed, and not for its picture. */
export class BlindDesk extends Desk {
  override async settled(): Promise<void> {
    await this.page.evaluate(async () => {
      await Promise.resolve();
      await window.__lissom.app.evaluator.settled();
    });
  }

  /** Opens the newest restore point of another tab or another day. */
  async openEarlier(title: string): Promise<void> {
    await this.command('restore points');
    await this.page.getByRole('dialog').getByRole('button', { name: 'Open' }).first().click();
    await this.page.waitForFunction((wanted) => window.__lissom.app.state.title.peek() === wanted, title);
    await this.settled();
  }
}

export interface VictimOptions {
  readonly baseURL: string;
  /** Restored into the new profile. */
  readonly profile?: Profile;
  /** False: as on plain http. */
  readonly locks?: boolean;
}

export class Victim {
  /** Recipes that were committed, oldest first, by the load of the page. */
  readonly #commits = new Map<string, string[]>();
  /** What pages threw and nobody caught, and messages that are no sentences for a person. */
  readonly troubles: string[] = [];

  private constructor(readonly context: BrowserContext) {}

  static async arrive(browser: Browser, { baseURL, profile, locks = true }: VictimOptions): Promise<Victim> {
    const context = await browser.newContext({
      baseURL,
      viewport: SIZE,
      reducedMotion: 'reduce',
      serviceWorkers: 'block', // it has tests of its own
      ...(profile && { storageState: profile }),
    });
    context.setDefaultTimeout(30_000);
    const victim = new Victim(context);
    await context.exposeBinding('__committed', (_, load: string, recipe: string) =>
      victim.#hear(load, recipe),
    );
    await context.addInitScript(instrument);
    if (!locks)
      await context.addInitScript(() => Object.defineProperty(navigator, 'locks', { value: undefined }));
    context.on('page', (page) =>
      page.on('pageerror', (error) => victim.troubles.push(error.stack ?? error.message)),
    );
    return victim;
  }

  /** The app in a tab of its own, as far as the browser has it. */
  async tab(): Promise<Page> {
    return withoutPickers(await this.context.newPage());
  }

  /** As duplicating a tab does, the new one takes the old one's session storage along. */
  async duplicate({ page }: Desk, address = '?test=1'): Promise<BlindDesk> {
    const opened = this.context.waitForEvent('page');
    await page.evaluate((there) => void window.open(there), address);
    const desk = new BlindDesk(await opened);
    await desk.ready();
    return desk;
  }

  async open(address = '?test=1'): Promise<BlindDesk> {
    const desk = new BlindDesk(await this.tab());
    await desk.open(address);
    return desk;
  }

  /** All that was committed in a load of a page, from what it opened with. */
  commits(load: string): readonly string[] {
    return this.#commits.get(load) ?? [];
  }

  async leave(): Promise<void> {
    await this.context.close();
  }

  #hear(load: string, recipe: string): void {
    this.#commits.set(load, [...this.commits(load), recipe]);
  }
}

/** The work in a page, once it is computed. */
export async function workIn(desk: Desk): Promise<Work> {
  await desk.settled();
  const { positions, ...work } = await desk.page.evaluate(() => {
    const { document, state, evaluator } = window.__lissom.app;
    return {
      load: window.__instruments.load,
      recipe: JSON.stringify(document.recipe, (_, value) => (Object.is(value, -0) ? '-0' : value)),
      saved: state.saved.peek().kind,
      positions: evaluator.result.peek() && [...evaluator.result.peek()!.positions],
    };
  });
  return { ...work, positions: positions && Float64Array.from(positions) };
}

export const saved = async ({ page }: Desk): Promise<void> => {
  await page.waitForFunction(() => ['saved', 'clean'].includes(window.__lissom.app.state.saved.peek().kind));
};

/** Runs in each page before its own scripts. */
function instrument(): void {
  const instruments: Instruments = {
    load: String(Math.random()),
    workers: [],
    databases: [],
    refusal: null,
  };
  const { open } = IDBFactory.prototype;
  const { put } = IDBObjectStore.prototype;
  Object.assign(IDBFactory.prototype, {
    open(this: IDBFactory, ...args: Parameters<typeof open>) {
      const request = open.apply(this, args);
      request.addEventListener('success', () => instruments.databases.push(request.result));
      return request;
    },
  });
  Object.assign(IDBObjectStore.prototype, {
    put(this: IDBObjectStore, ...args: Parameters<typeof put>) {
      if (instruments.refusal) throw new DOMException('refused for a test', instruments.refusal);
      return put.apply(this, args);
    },
  });
  class Watched extends Worker {
    constructor(address: string | URL, options?: WorkerOptions) {
      super(address, options);
      instruments.workers.push(this);
    }
  }
  Object.assign(window, { Worker: Watched, __instruments: instruments });
  // Nobody looks at these pictures, and software takes most of a trial's time to draw them.
  const nothing = () => {};
  Object.assign(WebGL2RenderingContext.prototype, {
    drawArrays: nothing,
    drawElements: nothing,
    drawElementsInstanced: nothing,
  });
  let app: typeof window.__lissom | undefined;
  Object.defineProperty(window, '__lissom', {
    configurable: true,
    get: () => app,
    set(value: typeof window.__lissom) {
      app = value;
      const { document } = value.app;
      document.onCommit(() =>
        window.__committed(
          instruments.load,
          JSON.stringify(document.recipe, (_, held) => (Object.is(held, -0) ? '-0' : held)),
        ),
      );
    },
  });
}
