// One fault at a random moment of random edits, and what is there again after it.

import type { Browser, Page } from '@playwright/test';
import { toIndices } from '../../../web/core/vertex-set';
import type { DeformStep } from '../../../web/recipe/recipe';
import { Random } from '../../fuzz/random';
import { type Desk, gap, handleGap } from '../desk';
import { BAR, BAR_RECIPE } from '../shapes';
import { chosen, isBackAndForth } from './edits';
import { DEATHS, type Death, end, type Fault, faults, type Heal } from './faults';
import { BlindDesk, type Profile, saved, Victim, type VictimOptions, workIn } from './victim';

export interface Outcome {
  readonly seed: number;
  readonly kind: string;
  /** What was done, in order. */
  readonly story: readonly string[];
  readonly edits: number;
  /** What is not as it was; empty where nothing was lost. */
  readonly lost: readonly string[];
}

/** A profile with a small document in it. */
export async function profileWithBar(browser: Browser, baseURL: string): Promise<Profile> {
  const victim = await Victim.arrive(browser, { baseURL });
  const desk = await victim.open();
  await desk.choose(['bar.json', BAR_RECIPE], ['bar.obj', BAR]);
  await saved(desk);
  const profile = await victim.context.storageState({ indexedDB: true });
  await victim.leave();
  return profile;
}

export const faultOf = (seed: number): Fault => faults[seed % faults.length]!;

/** @param seed  of all that is left to chance; of `fault`, too, when that is left out */
export async function trial(
  browser: Browser,
  options: Omit<VictimOptions, 'locks'>,
  seed: number,
  fault = faultOf(seed),
): Promise<Outcome> {
  const victim = await Victim.arrive(browser, { ...options, locks: fault.locks ?? true });
  const course = new Course(victim, fault, new Random(seed, 'fault'));
  try {
    await course.run();
  } catch (error) {
    course.lost.push(error instanceof Error ? (error.stack ?? error.message) : String(error));
  }
  await victim.leave();
  const { story, edits, lost } = course;
  return { seed, kind: fault.kind, story, edits, lost: [...lost, ...victim.troubles] };
}

/** An edit under way. */
interface Making {
  readonly name: string;
  readonly made: Promise<void>;
  isOver: boolean;
}

class Course {
  readonly story: string[] = [];
  readonly lost: string[] = [];
  edits = 0;

  constructor(
    private readonly victim: Victim,
    private readonly fault: Fault,
    private readonly random: Random,
  ) {}

  async run(): Promise<void> {
    const { fault, random, victim } = this;
    const desk = await victim.open();
    await this.#edit(desk, 1 + random.below(2));
    let heal: Heal | undefined;
    if (fault.begin) {
      const making = await this.#begin(desk);
      await pause(random.between(0, 500));
      heal = await fault.begin(victim, desk, random);
      this.story.push(fault.kind);
      await making.made;
      await this.#edit(desk, 1 + random.below(2));
      if (random.chance(0.5)) {
        await heal();
        heal = undefined;
        this.story.push('over');
      }
      await this.#isThere(desk, await this.#last(desk));
    }
    const death = random.pick(fault.deaths ?? DEATHS);
    const again = await this.#die(desk, death, heal);
    await this.#edit(again, 1);
    await saved(again);
  }

  /** Ends the page at some moment, opens it again and looks whether all is there. */
  async #die(desk: Desk, death: Death, heal?: Heal): Promise<Desk> {
    const { fault, random, victim } = this;
    // What nothing else can keep is safe once the page says so.
    if (fault.onlyOnceSaved) await this.#edited(desk).then(() => saved(desk));
    const before = await workIn(desk);
    const isAmidEdit = !fault.onlyOnceSaved && random.chance(0.6);
    const making = isAmidEdit ? await this.#begin(desk) : undefined;
    await pause(random.between(0, 600));
    const isOver = making?.isOver ?? true;
    await end(desk.page, death);
    this.story.push(death);
    const commits = [...victim.commits(before.load)];
    // One that was cut short may have gone on in the next page, and found nothing there that it was about.
    await (isOver ? making?.made : making?.made.catch(nothing));
    const isReadable = before.saved !== 'saved';
    if (heal && !isReadable) await heal();
    const again = await this.#reopened(desk.page, death);
    if (heal && isReadable) {
      await heal();
      await saved(again); // and has been given what the store kept back
    }
    await this.#isThere(again, commits.at(-1)!, isOver ? undefined : making, commits);
    const there = await workIn(again);
    if (there.recipe === before.recipe && before.positions)
      if (gap(before.positions, there.positions ?? new Float64Array()) !== 0)
        this.lost.push('the positions are not those of before');
    return again;
  }

  async #reopened(page: Page, death: Death): Promise<Desk> {
    const { fault, random, victim } = this;
    if (death === 'reload') {
      const desk = new BlindDesk(page);
      await desk.ready();
      await page.mouse.up();
      return desk;
    }
    for (let times = fault.whileOpening ? 1 + random.below(3) : 0; times > 0; times--) {
      const next = await victim.tab();
      const opening = next.goto('?test=1', { waitUntil: 'commit' }).catch(nothing);
      await pause(random.between(50, 1500));
      const how = random.pick<Death>(['close', 'crash']);
      await end(next, how);
      await opening;
      this.story.push(`${how} while it opens`);
    }
    return victim.open();
  }

  /**
   * @param last    the recipe that was committed last, as far as is known
   * @param making  an edit that may have been committed or not
   * @param seen    the recipes there were before
   */
  async #isThere(desk: Desk, last: string, making?: Making, seen: readonly string[] = []): Promise<void> {
    const { recipe, positions } = await workIn(desk);
    const isNewer = making && (isBackAndForth(making.name) || !seen.includes(recipe));
    if (recipe !== last && !isNewer) {
      const age = seen.lastIndexOf(recipe);
      const found = age < 0 ? 'something else' : `what was there ${seen.length - 1 - age} edits before`;
      this.lost.push(`the last edit is not there, but ${found}: ${recipe}\ninstead of ${last}`);
    }
    if (!positions) this.lost.push('nothing is computed');
    else if (!positions.every(Number.isFinite)) this.lost.push('positions are not finite');
    else await this.#handlesHold(desk);
  }

  /** Every handle that is alone on its vertices is where its matrix puts it. */
  async #handlesHold(desk: Desk): Promise<void> {
    const shown = await desk.shown();
    const { handles } = shown.step as DeformStep;
    const count = shown.rest.length / 3;
    const owners = new Map<number, number>();
    for (const { vertices } of handles)
      for (const v of toIndices(vertices, count)) owners.set(v, (owners.get(v) ?? 0) + 1);
    const alone = handles.filter(({ vertices }) =>
      [...toIndices(vertices, count)].every((v) => owners.get(v) === 1),
    );
    for (const handle of alone)
      if (!(handleGap(handle, shown) < 1e-5)) this.lost.push(`the handle ${handle.name} is not held`);
  }

  async #edit(desk: Desk, times: number): Promise<void> {
    for (; times > 0; times--) {
      await (await this.#begin(desk)).made;
      if (this.random.chance(0.3)) await pause(this.random.between(0, 1500));
    }
  }

  /** Edits until something has come of it. */
  async #edited(desk: Desk): Promise<void> {
    const { load } = await workIn(desk);
    const { length } = this.victim.commits(load);
    for (let i = 0; i < 20 && this.victim.commits(load).length === length; i++) await this.#edit(desk, 1);
  }

  async #begin(desk: Desk): Promise<Making> {
    const { name, make } = await chosen(desk, this.random);
    this.story.push(name);
    this.edits++;
    const making: Making = {
      name,
      isOver: false,
      made: make()
        .catch((error: Error) => {
          if (!/closed|crashed|navigat|destroyed|in sight/.test(error.message)) throw error;
        })
        .finally(() => {
          making.isOver = true;
        }),
    };
    making.made.catch(nothing); // whoever waits for it hears of it
    return making;
  }

  async #last(desk: Desk): Promise<string> {
    const { load } = await workIn(desk);
    return this.victim.commits(load).at(-1)!;
  }
}

const pause = (milliseconds: number): Promise<void> => new Promise((done) => setTimeout(done, milliseconds));

const nothing = (): void => {};
