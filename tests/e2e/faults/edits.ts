// Edits by chance, made by hand: real pointers and keys. What is not there to be edited is passed over.

import type { DeformHandle, DeformStep, Recipe } from '../../../web/recipe/recipe';
import type { Random } from '../../fuzz/random';
import type { Desk } from '../desk';
import { ofBar } from '../shapes';

/** What is open, read without waiting for anything. */
interface Open {
  readonly step: DeformStep | undefined;
  readonly steps: number;
  readonly selected: number | null;
}

interface Edit {
  readonly name: string;
  /** How often it is made, beside the others. */
  readonly weight: number;
  readonly fits?: (open: Open) => boolean;
  make(desk: Desk, random: Random, open: Open): Promise<void>;
}

const COUNT = ofBar(() => true).length;
const NAMES = ['Foot', 'Tip', 'Nose', 'Left hand', 'Ünï 1', '"quoted"', 'a / b'];
const hasHandles = ({ step }: Open) => (step?.handles.length ?? 0) > 0;
const nameOf = ({ name }: DeformHandle, index: number) => name ?? `Handle ${index + 1}`;

/** Selects a handle in the list. @returns its name */
async function select({ page }: Desk, { step, selected }: Open, index: number): Promise<string> {
  const handle = step!.handles[index]!;
  if (selected !== index)
    await page.getByRole('list', { name: 'Handles' }).locator('.row-main').nth(index).click();
  return nameOf(handle, index);
}

const edits: readonly Edit[] = [
  {
    name: 'drag',
    weight: 4,
    fits: hasHandles,
    async make(desk, random, { step }) {
      const { vertices } = random.pick(step!.handles);
      const grip = await desk.spot(await desk.reachable(vertices, COUNT));
      const by = { x: Math.round(random.between(-90, 90)), y: Math.round(random.between(-90, 90)) };
      await desk.hold(grip, by, 1 + random.below(3));
      await desk.page.mouse.up();
    },
  },
  {
    name: 'number',
    weight: 4,
    fits: hasHandles,
    async make(desk, random, open) {
      await select(desk, open, random.below(open.step!.handles.length));
      const field = desk.page.getByRole('textbox', { name: `Move ${random.pick(['X', 'Y', 'Z'])}` });
      await field.fill(random.between(-4, 4).toFixed(2));
      await field.press('Enter');
      await field.press('Escape');
    },
  },
  {
    name: 'paint a handle',
    weight: 2,
    async make(desk, random) {
      const along = 4 + random.below(9);
      await desk.page.keyboard.press('n');
      const spots = await desk.spots([along, along + 1].map(frontOf));
      await desk.page.mouse.move(spots[0]!.x, spots[0]!.y);
      await desk.page.mouse.down();
      await desk.page.mouse.move(spots[1]!.x, spots[1]!.y, { steps: 3 });
      await desk.page.mouse.up();
      await desk.page.keyboard.press('v');
    },
  },
  {
    name: 'point handle',
    weight: 2,
    async make(desk, random) {
      await desk.page.keyboard.press('p');
      const spot = await desk.spot(frontOf(4 + random.below(9)));
      await desk.page.mouse.click(spot.x, spot.y);
      await desk.page.keyboard.press('v');
    },
  },
  {
    name: 'remove a handle',
    weight: 1,
    fits: ({ step }) => (step?.handles.length ?? 0) > 1,
    async make(desk, random, open) {
      const index = random.below(open.step!.handles.length);
      await desk.page
        .getByRole('button', { name: `Delete ${nameOf(open.step!.handles[index]!, index)}`, exact: true })
        .first()
        .click();
    },
  },
  {
    name: 'rename',
    weight: 1,
    fits: hasHandles,
    async make(desk, random, open) {
      const name = await select(desk, open, random.below(open.step!.handles.length));
      const what = { name: `Rename ${name}`, exact: true };
      await desk.page.getByRole('button', what).first().click();
      await desk.page.getByRole('textbox', what).fill(random.pick(NAMES));
      await desk.page.keyboard.press('Enter');
    },
  },
  {
    name: 'method',
    weight: 1,
    async make({ page }, random) {
      const method = random.pick(['implicit', 'iterative', 'naive']);
      await page.getByLabel('Follow by').selectOption(method);
    },
  },
  {
    name: 'everything',
    weight: 1,
    make: (desk) => desk.page.keyboard.press('a'),
  },
  {
    name: 'another step',
    weight: 1,
    fits: (open) => hasHandles(open) && open.steps < 3,
    make: (desk) => desk.page.keyboard.press('Control+Enter'),
  },
  {
    name: 'remove a step',
    weight: 1,
    fits: ({ steps }) => steps > 1,
    async make({ page }, random, { steps }) {
      const section = page.getByRole('button', { name: 'Steps', exact: true });
      if ((await section.getAttribute('aria-expanded')) === 'false') await section.click();
      await page
        .getByRole('button', { name: /^Remove step / })
        .nth(random.below(steps))
        .click();
    },
  },
  { name: 'undo', weight: 3, make: (desk) => desk.page.keyboard.press('Control+z') },
  { name: 'redo', weight: 2, make: (desk) => desk.page.keyboard.press('Control+Shift+Z') },
];

/** The edits that lead to a state there was before. */
export const isBackAndForth = (name: string): boolean => name === 'undo' || name === 'redo';

/** Chooses an edit that fits what is open. */
export async function chosen(desk: Desk, random: Random): Promise<{ name: string; make(): Promise<void> }> {
  const open = await openIn(desk);
  const fitting = edits.filter(({ fits }) => fits?.(open) ?? true);
  const { name, make } = random.pick(fitting.flatMap((edit) => Array<Edit>(edit.weight).fill(edit)));
  return { name, make: () => make(desk, random, open) };
}

/** On the side of the bar that faces the viewer. */
const frontOf = (x: number): number => ofBar((vx, vy, vz) => vx === x && vy === 2 && vz === 4)[0]!;

const openIn = (desk: Desk): Promise<Open> =>
  desk.page.evaluate(() => {
    const { document, state } = window.__lissom.app;
    const { step, item } = state.selection.peek();
    const recipe = document.recipe as Recipe;
    return {
      step: recipe.steps.find((each): each is DeformStep => each.id === step && each.type === 'deform'),
      steps: recipe.steps.length,
      selected: item,
    };
  });
