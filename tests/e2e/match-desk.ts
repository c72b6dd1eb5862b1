// Hands and eyes for the match workspace, beside those of the desk.

import type { MatchWing } from '../../web/app/match/wing';
import { writeModel } from '../../web/io/formats';
import type { MatchStep } from '../../web/recipe/recipe';
import type { Vec3 } from '../../web/view/types';
import { type Ball, fig, pear, plum } from '../kernel/balls';
import { type ChosenFile, type Desk, expect, type Place } from './desk';

export const FRUIT: Readonly<Record<'pear' | 'plum' | 'fig', Ball>> = {
  pear: pear(),
  plum: plum(),
  fig: fig(),
};
export type Fruit = keyof typeof FRUIT;

export const fileOf = (name: Fruit): ChosenFile => [
  `${name}.obj`,
  writeModel({ name, ...FRUIT[name] }, 'obj'),
];

/** Where a place of the ball that all of them were made of is on each of them. */
const PLACED: Readonly<Record<Fruit, (x: number, y: number, z: number) => Vec3>> = {
  pear: (x, y, z) => [x, 1.3 * y, z],
  plum: (x, y, z) => [1.4 * x, y, (1 + 0.2 * y) * z],
  fig: (x, y, z) => [x * (1 - 0.3 * y), 1.1 * y, 0.8 * z],
};

export interface ShownMatch {
  readonly step: MatchStep;
  readonly selected: number | null;
  readonly outdated: boolean;
  readonly problem: string | null;
  /** Of each model: mean distance and what 99 of 100 places are nearer than. */
  readonly quality: readonly { readonly mean: number; readonly p99: number; readonly flipped: number }[];
  /** Vertices of the skins; 0: there are none. */
  readonly skin: number;
  /** Numbers of the models on which a place is suggested. */
  readonly ghosts: readonly number[];
}

export async function matched(desk: Desk): Promise<ShownMatch> {
  await desk.settled();
  const read = await desk.page.evaluate(() => {
    const { app } = window.__lissom;
    const { state } = app.wings.get('match') as MatchWing;
    const result = state.result.peek();
    return {
      step: JSON.stringify(state.step.peek()!),
      selected: app.state.selection.peek().item,
      outdated: state.outdated.peek(),
      problem: state.problem.peek(),
      quality: result?.quality ?? [],
      skin: (result?.models[0]?.positions.length ?? 0) / 3,
      ghosts: state.ghosts.peek().map(({ model }) => model),
    };
  });
  return { ...read, step: JSON.parse(read.step) as MatchStep };
}

/** Opens a fruit, enters the workspace, and takes a second one from a file. */
export async function chooseFruit(desk: Desk, first: Fruit, second: Fruit): Promise<void> {
  const { page } = desk;
  await desk.choose(fileOf(first));
  await page.getByRole('navigation').getByRole('button', { name: 'Match', exact: true }).click();
  await expect(page.getByRole('heading', { name: 'Choose a model to match' })).toBeVisible();
  await desk.choose(fileOf(second));
  await shownModels(desk, 2);
}

/** Waits until so many models are on screen. */
export async function shownModels(desk: Desk, count: number): Promise<void> {
  await desk.page.waitForFunction((wanted) => {
    const { state } = window.__lissom.app.wings.get('match') as MatchWing;
    return (
      state.models.peek().length === wanted && document.querySelectorAll('.match-cell').length === wanted
    );
  }, count);
  await desk.settled();
  // Panes have their size, and frame what is in them, with their first picture.
  await desk.page.waitForTimeout(300);
}

/** On the page: where a place of the ball is on one of the models. */
export async function spotOn(desk: Desk, at: number, fruit: Fruit, ball: Vec3): Promise<Place> {
  const length = Math.hypot(...ball);
  const [x, y, z] = ball.map((c) => c / length) as [number, number, number];
  const point = PLACED[fruit](x, y, z);
  return desk.page.evaluate(
    ([number, place]) => {
      const { app } = window.__lissom;
      const view = number === 0 ? app.viewport! : app.panes.all.peek()[number - 1]!.viewport;
      const canvas =
        number === 0
          ? document.querySelector('.stage > .viewport canvas')!
          : document.querySelectorAll('.match-cell')[number]!.querySelector('canvas')!;
      const box = canvas.getBoundingClientRect();
      const seen = view.project(place);
      return { x: box.left + seen.x, y: box.top + seen.y };
    },
    [at, point] as const,
  );
}

/** The suggestion that the app makes is there. */
export async function suggested(desk: Desk): Promise<void> {
  await desk.page.waitForFunction(() => {
    const { state } = window.__lissom.app.wings.get('match') as MatchWing;
    return state.ghosts.peek().length > 0;
  });
}
