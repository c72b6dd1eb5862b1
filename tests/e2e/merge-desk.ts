// Hands and eyes for the merge workspace, beside those of the desk.

import type { Page } from '@playwright/test';
import type { MergeWing } from '../../web/app/merge/wing';
import { parseRecipe } from '../../web/recipe/parse';
import type { MergeStep, Recipe } from '../../web/recipe/recipe';
import type { MergeSide } from '../../web/tools/merge/pins';
import type { Vec3 } from '../../web/view/types';
import { type Desk, expect, type Place } from './desk';

export interface ShownMerge {
  readonly recipe: Recipe;
  readonly step: MergeStep;
  /** Of what the result pane shows. */
  readonly positions: Float64Array;
  readonly figures: {
    readonly closed: boolean;
    readonly eulerCharacteristic: number;
    readonly energy: readonly number[];
  } | null;
  readonly problem: string | null;
  readonly pins: readonly (readonly [source: number, target: number])[];
}

export async function merged({ page, settled }: Desk): Promise<ShownMerge> {
  await settled.call({ page });
  const read = await page.evaluate(() => {
    const { document, evaluator } = window.__lissom.app;
    const { state, actions } = window.__lissom.app.wings.get('merge') as MergeWing;
    return {
      recipe: JSON.stringify(document.recipe),
      positions: [...evaluator.result.peek()!.positions],
      figures: state.figures.peek(),
      problem: state.problem.peek(),
      pins: actions.joins.pins().map(({ vertices }) => vertices),
      step: state.step.peek()!.id,
    };
  });
  const recipe = parseRecipe(read.recipe);
  const step = recipe.steps.find(({ id }) => id === read.step) as MergeStep;
  return { ...read, recipe, step, positions: Float64Array.from(read.positions) };
}

/** Where points of one of the two models are on the page. */
export const spots = (page: Page, side: MergeSide, points: readonly Vec3[]): Promise<Place[]> =>
  page.evaluate(
    ([pane, wanted]) => {
      const view = window.__lissom.app.panes.all.peek()[pane === 'source' ? 0 : 1]!.viewport;
      const box = document.querySelector(`.pane.${pane}`)!.getBoundingClientRect();
      return wanted.map((point) => {
        const { x, y } = view.project(point);
        return { x: box.left + x, y: box.top + y };
      });
    },
    [side, points] as const,
  );

/** The place of a vertex of one of the two models. */
export async function spotOf(page: Page, side: MergeSide, vertex: number): Promise<Place> {
  const point = await page.evaluate(
    ([pane, v]) => {
      const { state } = window.__lissom.app.wings.get('merge') as MergeWing;
      const { positions } = state.sides.peek()[pane]!.model;
      return [positions[3 * v]!, positions[3 * v + 1]!, positions[3 * v + 2]!] as const;
    },
    [side, vertex] as const,
  );
  const [spot] = await spots(page, side, [point]);
  return spot!;
}

/** One stroke with the tool in hand over points of a model. */
export async function strokeOver(desk: Desk, side: MergeSide, points: readonly Vec3[]): Promise<void> {
  const { mouse } = desk.page;
  const [first, ...rest] = await spots(desk.page, side, points);
  await mouse.move(first!.x, first!.y);
  await mouse.down();
  for (const { x, y } of rest) await mouse.move(x, y, { steps: 2 });
  await mouse.up();
  await desk.settled();
}

/** Enters the workspace and takes a gallery model for the part. */
export async function choosePart(desk: Desk, title: string): Promise<void> {
  const { page } = desk;
  await page.getByRole('navigation').getByRole('button', { name: 'Merge', exact: true }).click();
  await expect(page.getByRole('heading', { name: 'Choose the part to add' })).toBeVisible();
  await page.locator('.model-chooser').getByRole('button', { name: title }).click();
  await page.waitForFunction(
    () => (window.__lissom.app.wings.get('merge') as MergeWing).state.sides.peek().source !== null,
  );
  await desk.settled();
}

export async function pressMerge(desk: Desk): Promise<void> {
  await desk.page.locator('.merge-go').getByRole('button', { name: 'Merge' }).click();
  await desk.page.waitForFunction(() => {
    const { figures, problem } = (window.__lissom.app.wings.get('merge') as MergeWing).state;
    return figures.peek() !== null || problem.peek() !== null;
  });
  await desk.settled();
}
