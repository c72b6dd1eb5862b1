// What the end-to-end tests have in common: a page with the app in it, hands to work it by, eyes to read its
// state by. Hands are real input events only; `window.__lissom` is read, never written.

import { type Browser, test as base, type Download, expect, type Page } from '@playwright/test';
import type { BuiltApp } from '../../web/app/app';
import { toIndices, type VertexSet } from '../../web/core/vertex-set';
import type { DeformHandle, DeformStep } from '../../web/recipe/recipe';
import { pointAt, transform } from '../../web/tools/geometry';
import type { Vec3 } from '../../web/view/types';
import { BAR, BAR_RECIPE } from './shapes';

declare global {
  interface Window {
    readonly __lissom: { readonly app: BuiltApp; readonly ready: Promise<void> };
  }
}

export interface Place {
  readonly x: number;
  readonly y: number;
}

/** What is on screen: the open step and where every vertex of its model is. */
export interface Shown {
  readonly step: DeformStep;
  readonly rest: Float64Array;
  readonly positions: Float64Array;
  readonly selected: number | null;
}

export class Desk {
  constructor(readonly page: Page) {}

  /** Opens the app and waits for its first picture. `address` is relative to the site. */
  async open(address = '?test=1'): Promise<void> {
    await this.page.goto(address);
    await this.ready();
  }

  async ready(): Promise<void> {
    await this.page.waitForFunction(() => window.__lissom !== undefined);
    await this.page.evaluate(() => window.__lissom.ready);
    await this.settled();
  }

  /** Waits until nothing runs, waits or is measured. */
  async settled(): Promise<void> {
    await this.page.evaluate(async () => {
      const frame = () => new Promise(requestAnimationFrame);
      await frame();
      await window.__lissom.app.evaluator.settled();
      await frame();
    });
  }

  async shown(): Promise<Shown> {
    await this.settled();
    const read = await this.page.evaluate(() => {
      const { app } = window.__lissom;
      const result = app.evaluator.result.peek();
      if (!result) return null;
      const { step, shown, positions } = result;
      const selected = app.state.selection.peek().item;
      return { step, rest: [...shown.model.positions], positions: [...positions], selected };
    });
    if (!read) throw new Error('nothing is shown');
    const { selected } = read;
    const step = read.step as unknown as DeformStep;
    return {
      step,
      selected,
      rest: Float64Array.from(read.rest),
      positions: Float64Array.from(read.positions),
    };
  }

  /** Steps of undo there are, and which of them is shown. */
  history(): Promise<{ readonly entries: number; readonly index: number }> {
    return this.page.evaluate(() => {
      const { document } = window.__lissom.app;
      return { entries: document.entries.length, index: document.index };
    });
  }

  title(): Promise<string> {
    return this.page.evaluate(() => window.__lissom.app.state.title.peek());
  }

  /** Where a vertex is on the page now. */
  async spot(vertex: number): Promise<Place> {
    const [place] = await this.spots([vertex]);
    return place!;
  }

  async spots(vertices: readonly number[]): Promise<Place[]> {
    const { positions } = await this.shown();
    return this.project(...vertices.map((v) => pointAt(positions, v)));
  }

  /** Where points of the model are on the page. */
  project(...points: readonly Vec3[]): Promise<Place[]> {
    return this.page.evaluate((wanted) => {
      const box = document.querySelector('canvas')!.getBoundingClientRect();
      return wanted.map((point) => {
        const { x, y } = window.__lissom.app.viewport!.project(point);
        return { x: box.left + x, y: box.top + y };
      });
    }, points);
  }

  /** A vertex of the set that the pointer can reach: nothing is in front of it. Nearest to the set's middle. */
  async reachable(set: VertexSet, count: number): Promise<number> {
    const found = await this.page.evaluate(
      (vertices) => {
        const { app } = window.__lissom;
        const { positions } = app.evaluator.result.peek()!;
        const within = new Set(vertices);
        const at = (v: number) => [...positions.subarray(3 * v, 3 * v + 3)] as [number, number, number];
        const few = Math.ceil(vertices.length / 80);
        const seen = vertices
          .filter((_, i) => i % few === 0)
          .map((v) => ({ v, ...app.viewport!.project(at(v)) }))
          .filter(({ x, y }) => within.has(app.viewport!.pick(x, y)?.vertex ?? -1));
        const [cx, cy] = (['x', 'y'] as const).map(
          (k) => seen.reduce((sum, s) => sum + s[k], 0) / seen.length,
        );
        seen.sort((a, b) => Math.hypot(a.x - cx!, a.y - cy!) - Math.hypot(b.x - cx!, b.y - cy!));
        return seen[0]?.v ?? null;
      },
      [...toIndices(set, count)],
    );
    if (found === null) throw new Error('none of these vertices is in sight');
    return found;
  }

  /** Where to take hold of a handle. */
  async grip(index: number): Promise<Place> {
    const { step, rest } = await this.shown();
    return this.spot(await this.reachable(step.handles[index]!.vertices, rest.length / 3));
  }

  /** Press, move and hold: what `drop` or Escape ends. */
  async hold(from: Place, by: Place, steps = 4): Promise<void> {
    const { mouse } = this.page;
    await mouse.move(from.x, from.y);
    await mouse.down();
    for (let i = 1; i <= steps; i++)
      await mouse.move(from.x + (by.x * i) / steps, from.y + (by.y * i) / steps);
  }

  async drag(from: Place, by: Place, steps = 4): Promise<void> {
    await this.hold(from, by, steps);
    await this.page.mouse.up();
    await this.settled();
  }

  /** One stroke over the places of these vertices. */
  async stroke(vertices: readonly number[]): Promise<void> {
    const { mouse } = this.page;
    const [first, ...rest] = await this.spots(vertices);
    await mouse.move(first!.x, first!.y);
    await mouse.down();
    for (const { x, y } of rest) await mouse.move(x, y, { steps: 3 });
    await mouse.up();
    await this.settled();
  }

  async press(key: string): Promise<void> {
    await this.page.keyboard.press(key);
    await this.settled();
  }

  /** Runs a command the way a person does who knows its name: through the palette. */
  async command(name: string): Promise<void> {
    await this.page.keyboard.press('Control+k');
    await this.page.getByRole('combobox', { name: 'Commands' }).fill(name);
    await this.page.keyboard.press('Enter');
    await this.settled();
  }

  /** The link that the share dialog copies; the dialog stays open. */
  async copiedLink(): Promise<string> {
    await this.command('share');
    await this.page.getByRole('button', { name: 'Copy link' }).click();
    await expect(this.page.getByText(/Link copied: [\d,]+ characters\./)).toBeVisible();
    return this.page.evaluate(() => navigator.clipboard.readText());
  }

  /** Chooses files in the system's dialog. */
  async choose(...files: readonly ChosenFile[]): Promise<void> {
    const asked = this.page.waitForEvent('filechooser');
    await this.page.keyboard.press('Control+o');
    await (await asked).setFiles(
      files.map(([name, content]) => ({
        name,
        mimeType: 'application/octet-stream',
        buffer: Buffer.from(content),
      })),
    );
    await this.read();
  }

  /** Chooses files whose model takes long to be prepared, and cancels that. */
  async chooseAndCancel(...files: readonly ChosenFile[]): Promise<void> {
    const opened = this.choose(...files);
    const cancel = this.page.getByRole('button', { name: 'Cancel' });
    await cancel.click({ timeout: 60_000 });
    await opened;
    await expect(cancel).toBeHidden();
    expect(await this.page.locator('.toast.bad').count()).toBe(0);
  }

  /** Waits until a file that was chosen or dropped has been read. */
  async read(): Promise<void> {
    await this.page.waitForTimeout(50);
    await this.page.waitForFunction(() => window.__lissom.app.state.busy.peek() === null);
    await this.settled();
  }

  /** The text of the newest message. */
  toast(): Promise<string> {
    return this.page.locator('.toast > span:nth-child(2)').last().innerText();
  }

  /** Looks at the picture: how many different colours a coarse sample of the canvas has. */
  colours(): Promise<number> {
    return this.page.evaluate(async () => {
      const bitmap = await createImageBitmap(await window.__lissom.app.viewport!.screenshot(160, 120));
      const context = new OffscreenCanvas(160, 120).getContext('2d')!;
      context.drawImage(bitmap, 0, 0);
      const { data } = context.getImageData(0, 0, 160, 120);
      const seen = new Set<number>();
      for (let i = 0; i < data.length; i += 4)
        seen.add((data[i]! >> 3) | ((data[i + 1]! >> 3) << 5) | ((data[i + 2]! >> 3) << 10));
      return seen.size;
    });
  }

  /** Keeps a picture for people to look at. */
  async picture(name: string): Promise<void> {
    await this.page.screenshot({ path: `tests/e2e/pictures/${name}.png` });
  }
}

/** Name and content. */
export type ChosenFile = readonly [name: string, content: string | Uint8Array];

interface Fixtures {
  /** One page for a whole run, on a small bar with two handles at rest. */
  readonly desk: Desk;
  /** A page of its own in a browser profile of its own, as a first visitor sees it. */
  readonly fresh: Desk;
}

/** The system's file dialogs cannot be operated by tests: the page falls back to input and download. */
export async function withoutPickers(page: Page): Promise<Page> {
  await page.addInitScript(() => {
    for (const name of ['showOpenFilePicker', 'showSaveFilePicker']) Reflect.deleteProperty(window, name);
  });
  return page;
}

/** Small: software rendering pays by the pixel. */
export const SIZE = { width: 940, height: 600 };

export const test = base.extend<Fixtures, { readonly shared: { desk: Desk; errors: string[] } }>({
  shared: [
    async ({ browser }, use) => {
      const context = await browser.newContext({
        viewport: SIZE,
        reducedMotion: 'reduce',
        baseURL: base.info().project.use.baseURL!,
      });
      const page = await withoutPickers(await context.newPage());
      const errors = listenForErrors(page);
      const desk = new Desk(page);
      await desk.open();
      await use({ desk, errors });
      await context.close();
    },
    { scope: 'worker' },
  ],
  desk: async ({ shared: { desk, errors } }, use) => {
    errors.length = 0;
    await desk.page.setViewportSize(SIZE);
    await desk.page.keyboard.press('Escape');
    await desk.choose(['bar.json', BAR_RECIPE], ['bar.obj', BAR]);
    await use(desk);
    expect(errors, 'errors nobody caught').toEqual([]);
  },
  fresh: async ({ page }, use) => {
    const errors = listenForErrors(page);
    const desk = new Desk(await withoutPickers(page));
    await desk.open();
    await use(desk);
    expect(errors, 'errors nobody caught').toEqual([]);
  },
});

function listenForErrors(page: Page): string[] {
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(error.stack ?? error.message));
  return errors;
}

export { expect };

/** What another visitor sees who opens an address. Their context is theirs to close. */
export async function visitorAt(browser: Browser, address: string): Promise<Desk> {
  const context = await browser.newContext({ viewport: SIZE });
  const visitor = new Desk(await withoutPickers(await context.newPage()));
  await visitor.open(forTest(address));
  return visitor;
}

/** Tests do without motion and smoothing. */
export function forTest(address: string): string {
  const url = new URL(address);
  url.searchParams.set('test', '1');
  return url.href;
}

/** Bytes of a download. */
export async function bytesOf(download: Download): Promise<Uint8Array> {
  const chunks: Buffer[] = [];
  for await (const chunk of await download.createReadStream()) chunks.push(chunk as Buffer);
  return new Uint8Array(Buffer.concat(chunks));
}

export function diagonal(positions: Float64Array): number {
  const spans = [0, 1, 2].map((k) => {
    const along = positions.filter((_, i) => i % 3 === k);
    return along.reduce((a, b) => Math.max(a, b)) - along.reduce((a, b) => Math.min(a, b));
  });
  return Math.hypot(...spans);
}

/** The largest difference of two sets of coordinates; infinite where they are not even as many. */
export const gap = (a: Float64Array, b: Float64Array): number =>
  a.length === b.length ? a.reduce((worst, x, i) => Math.max(worst, Math.abs(x - b[i]!)), 0) : Infinity;

/** How far the worst vertex of a handle is from where the handle's matrix takes it. */
export function handleGap(handle: DeformHandle, { rest, positions }: Shown): number {
  const gaps = [...toIndices(handle.vertices, rest.length / 3)].map((v) => {
    const wanted = handle.kind === 'point' ? handle.position : transform(handle.matrix, pointAt(rest, v));
    return Math.hypot(...pointAt(positions, v).map((x, k) => x - wanted[k]!));
  });
  return gaps.reduce((a, b) => Math.max(a, b), 0);
}

/** Vertices that may move: the region and the handles. */
export function mayMove({ step, rest }: Pick<Shown, 'step' | 'rest'>): Set<number> {
  const count = rest.length / 3;
  return new Set(
    [step.roi, ...step.handles.map(({ vertices }) => vertices)].flatMap((set) => [...toIndices(set, count)]),
  );
}

/** Vertices whose position differs in any bit. */
export function moved({ rest, positions }: Pick<Shown, 'rest' | 'positions'>): number[] {
  return Array.from({ length: rest.length / 3 }, (_, v) => v).filter((v) =>
    [0, 1, 2].some((k) => !Object.is(rest[3 * v + k], positions[3 * v + k])),
  );
}
