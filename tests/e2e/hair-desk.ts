// Hands and eyes for the hair workspace, beside those of the desk.

import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import { FolderModels } from '../../web/cli/models';
import { loadKernel } from '../../web/kernel/node';
import { parseRecipe } from '../../web/recipe/parse';
import type { HairStep, Recipe } from '../../web/recipe/recipe';
import { Runner } from '../../web/run/evaluate';
import type { Vec3 } from '../../web/view/types';
import { type Desk, expect, type Place } from './desk';

export interface ShownHair {
  readonly recipe: Recipe;
  readonly step: HairStep;
  readonly strands: number;
  readonly color: string;
  /** Of offsets and points, byte for byte. */
  readonly hash: string;
}

export async function hair(desk: Desk): Promise<ShownHair> {
  await desk.settled();
  const read = await desk.page.evaluate(async () => {
    const { document, evaluator } = window.__lissom.app;
    const { step, strands } = evaluator.result.peek()!;
    const parts = strands ? [strands.offsets, strands.points] : [];
    const digest = await crypto.subtle.digest('SHA-256', await new Blob(parts as BlobPart[]).arrayBuffer());
    return {
      recipe: JSON.stringify(document.recipe),
      step: JSON.stringify(step),
      strands: strands ? strands.offsets.length - 1 : 0,
      color: strands?.look.color ?? '',
      hash: Array.from(new Uint8Array(digest), (byte) => byte.toString(16).padStart(2, '0')).join(''),
    };
  });
  return { ...read, recipe: JSON.parse(read.recipe), step: JSON.parse(read.step) };
}

/** What the command line grows of a recipe's last step. */
export async function grownHere(recipe: Recipe): Promise<string> {
  const runner = new Runner({ kernel: await loadKernel(), models: new FolderModels('.') });
  const { strands } = (await runner.run(parseRecipe(recipe))).get(recipe.steps.at(-1)!.id)!;
  return createHash('sha256').update(strands!.offsets).update(strands!.points).digest('hex');
}

/** A style of the gallery with another number of strands, on another grid. */
export function styleOf(file: string, count: number, resolution?: number): Recipe {
  const recipe = parseRecipe(readFileSync(`public/gallery/recipes/${file}`, 'utf8'));
  const steps = recipe.steps.map((step) =>
    step.type === 'hair'
      ? {
          ...step,
          strands: { ...step.strands, count },
          grid: { resolution: resolution ?? step.grid.resolution },
        }
      : step,
  );
  return { ...recipe, steps };
}

/** The hair workspace as somebody enters it for the first time, with few strands. */
export async function enter(desk: Desk, count: number): Promise<void> {
  await desk.page.getByRole('button', { name: 'Hair', exact: true }).first().click();
  await expect.poll(() => desk.page.evaluate(() => window.__lissom.app.state.workspace.peek())).toBe('hair');
  await desk.settled();
  await type(desk, 'Strands', count);
}

export async function type(desk: Desk, label: string, value: number): Promise<void> {
  const field = desk.page.getByRole('textbox', { name: label, exact: true });
  await field.click();
  await field.fill(String(value));
  await field.press('Enter');
  await field.blur();
  await desk.settled();
}

/** Where a place of the canvas is on the page: 0 0 is its middle, 1 half its height to the right, or down. */
export type Spot = readonly [number, number];

export async function spots(page: Page, ...at: readonly Spot[]): Promise<Place[]> {
  const box = (await page.locator('canvas').first().boundingBox())!;
  const half = box.height / 2;
  return at.map(([x, y]) => ({ x: box.x + box.width / 2 + half * x, y: box.y + half + half * y }));
}

/** One stroke through these places of the page. */
export async function draw(desk: Desk, ...places: readonly Place[]): Promise<void> {
  const { mouse } = desk.page;
  const [first, ...rest] = places;
  await mouse.move(first!.x, first!.y);
  await mouse.down();
  for (const { x, y } of rest) await mouse.move(x, y, { steps: 5 });
  await mouse.up();
  await desk.settled();
}

export async function drawAt(desk: Desk, ...at: readonly Spot[]): Promise<void> {
  await draw(desk, ...(await spots(desk.page, ...at)));
}

/** Where a curve is on the page: its points at these parts of its length, counted in points. */
export function along(
  desk: Desk,
  curve: readonly (readonly number[])[],
  ...parts: number[]
): Promise<Place[]> {
  const at = (part: number) => curve[Math.round(part * (curve.length - 1))] as Vec3;
  return desk.project(...parts.map(at));
}

export const beside = ({ x, y }: Place, right: number, down: number): Place => ({
  x: x + right,
  y: y + down,
});
