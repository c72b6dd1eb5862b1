// Hands and eyes for the transfer workspace, beside those of the desk.

import type { Page } from '@playwright/test';
import type { TransferWing } from '../../web/app/transfer/wing';
import type { TransferStep } from '../../web/recipe/recipe';
import type { Vec3 } from '../../web/view/types';
import { type Desk, expect, type Place } from './desk';

export interface ShownTransfer {
  readonly step: TransferStep;
  readonly rest: Float64Array;
  /** Where the model is that gets the pose. */
  readonly positions: Float64Array;
  readonly open: readonly number[];
  readonly selected: number | null;
  readonly figures: { readonly unknowns: number } | null;
  readonly problem: string | null;
}

export async function transferred(desk: Desk): Promise<ShownTransfer> {
  await desk.settled();
  const read = await desk.page.evaluate(() => {
    const { app } = window.__lissom;
    const { state, actions } = app.wings.get('transfer') as TransferWing;
    const { shown, positions } = app.evaluator.result.peek()!;
    return {
      step: JSON.stringify(state.step.peek()!),
      rest: [...shown.model.positions],
      positions: [...positions],
      open: actions.open(),
      selected: app.state.selection.peek().item,
      figures: state.figures.peek(),
      problem: state.problem.peek(),
    };
  });
  return {
    ...read,
    step: JSON.parse(read.step) as TransferStep,
    rest: Float64Array.from(read.rest),
    positions: Float64Array.from(read.positions),
  };
}

/** Enters the workspace and takes a gallery model to get the pose. */
export async function chooseTarget(desk: Desk, title: string): Promise<void> {
  const { page } = desk;
  await page.getByRole('navigation').getByRole('button', { name: 'Transfer', exact: true }).click();
  await expect(page.getByRole('heading', { name: 'Choose the model that gets the pose' })).toBeVisible();
  await page.locator('.model-chooser').getByRole('button', { name: title, exact: true }).click();
  await page.waitForFunction(() => {
    const { state } = window.__lissom.app.wings.get('transfer') as TransferWing;
    return state.step.peek() !== undefined && state.positions.peek() !== null;
  });
  await desk.settled();
}

/** A place on the page where a handle of the posed model is in sight. */
export async function spotOnSource(page: Page, handle: number): Promise<Place> {
  const found = await page.evaluate((index) => {
    const { app } = window.__lissom;
    const { handles, posed } = (app.wings.get('transfer') as TransferWing).state.source.peek()!;
    const { viewport } = app.panes.all.peek()[0]!;
    const box = document.querySelector('.pane.beside')!.getBoundingClientRect();
    const set = handles[index]!.vertices;
    const within = (v: number) =>
      set === 'all' ||
      ('ranges' in set ? set.ranges.some(([first, last]) => first <= v && v <= last) : set.includes(v));
    for (let v = 0; v < posed.length / 3; v++) {
      if (!within(v)) continue;
      const { x, y } = viewport.project([posed[3 * v]!, posed[3 * v + 1]!, posed[3 * v + 2]!]);
      const hit = viewport.pick(x, y);
      if (hit && within(hit.vertex)) return { x: box.left + x, y: box.top + y };
    }
    return null;
  }, handle);
  if (!found) throw new Error('the handle is not in sight');
  return found;
}

/** Vertices of the model that gets the pose, within a ball at rest. */
export const ballOf = ({ rest }: Pick<ShownTransfer, 'rest'>, centre: Vec3, radius: number): number[] =>
  Array.from({ length: rest.length / 3 }, (_, v) => v).filter(
    (v) =>
      Math.hypot(rest[3 * v]! - centre[0], rest[3 * v + 1]! - centre[1], rest[3 * v + 2]! - centre[2]) <
      radius,
  );
