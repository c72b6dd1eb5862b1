// Recipe -> results: a pure function of the recipe and its models, with caches that only save time.

import { cancelled, LissomError } from '../core/errors';
import { hashValue } from '../core/hash';
import { Lru } from '../core/lru';
import { faceCount, type Model, vertexCount } from '../core/model';
import type { KernelPort, Measured, RegionMaps } from '../kernel/contract';
import { referencesOf } from '../recipe/cross-checks';
import { stepById } from '../recipe/edit';
import { pathText } from '../recipe/problem';
import type { MergeStep, Recipe, Step } from '../recipe/recipe';
import { modelPlace, type Plan, plan, stepPlace } from './plan';
import { KernelSession } from './session';
import { runnerOf } from './steps/all';
import { type HairField, hairField } from './steps/hair';
import { paintedRegions } from './steps/merge';
import type { InputShape, StepOutcome } from './steps/step-runner';
import { type ModelResult, type ModelSource, placed, type StepResult } from './types';

export interface RunOptions {
  /** Id of the last step wanted; only what it depends on is run. All steps when left out. */
  readonly until?: string;
  readonly signal?: AbortSignal;
  /** @param fraction  of all steps, in [0, 1]; @param step  the one under way */
  readonly onProgress?: (fraction: number, step: Step) => void;
  /** False: quick previews will do (the first solve of a deform step). */
  readonly settle?: boolean;
  /** Also measure what the last step did to its input. */
  readonly measure?: boolean;
}

/** Bytes of positions and strands that cached results may hold. */
const RESULT_BYTES = 256 * 1024 * 1024;
/** A run may meet the end of a worker that somebody else's cancel had replaced, and once more that of its own. */
const ATTEMPTS = 3;

interface Cached extends StepOutcome {
  measured?: Measured;
}

/** A model on its way through the steps. */
interface Stage {
  readonly model: Model;
  readonly key: string;
  readonly place: string;
}

export class Runner {
  readonly #source: ModelSource;
  readonly #session: KernelSession;
  readonly #results = new Lru<Cached>(RESULT_BYTES);
  readonly #serials = new WeakMap<Model, number>();
  #nextSerial = 1;
  #last: Promise<unknown> = Promise.resolve();

  constructor({ kernel, models }: { readonly kernel: KernelPort; readonly models: ModelSource }) {
    this.#source = models;
    this.#session = new KernelSession(kernel);
  }

  /**
   * The results of the steps asked for and of those they depend on, by step id. Runs asked for at the same time
   * follow each other.
   *
   * @throws LissomError  the user's (`index-out-of-range`, what readers and kernel refuse), the machine's, `cancelled`;
   *                      as a PlacedError where a step or model is to blame
   */
  run(recipe: Recipe, options: RunOptions = {}): Promise<Map<string, StepResult>> {
    return this.#inTurn(async () => {
      if (options.signal?.aborted) throw cancelled();
      const planned = await plan(recipe, this.#source, options.until);
      return this.#persistently(options.signal, () => this.#run(recipe, planned, options));
    });
  }

  /** The opened model that a step starts from, or that a model's name stands for; of a merge step its source. */
  input(recipe: Recipe, id: string, options: Pick<RunOptions, 'signal'> = {}): Promise<ModelResult> {
    const step = stepById(recipe, id);
    return this.opened(recipe, step ? referencesOf(step)[0]!.name : id, options);
  }

  /** The opened model under a name: one of the recipe's models, or what a step leaves. */
  opened(recipe: Recipe, name: string, { signal }: Pick<RunOptions, 'signal'> = {}): Promise<ModelResult> {
    return this.#inTurn(async () => {
      const planned = await plan(recipe, this.#source, name);
      return this.#persistently(signal, async () => {
        const stages = this.#stages(recipe, planned);
        await this.#run(recipe, planned, signal ? { signal } : {}, stages);
        return this.#open(stages.get(name)!, signal);
      });
    });
  }

  /** Closed paths around painted vertices of a model or a step's result, the painted side to their left. */
  async loopsAround(recipe: Recipe, name: string, vertices: Uint32Array): Promise<readonly Uint32Array[]> {
    const { opened } = await this.opened(recipe, name);
    return this.#session.call('loopsAround', { model: opened.model, vertices });
  }

  /** The plane maps that a merge step's optimal boundary is sought in. */
  async mergeMaps(recipe: Recipe, { source, target, optimalBoundary }: MergeStep): Promise<RegionMaps> {
    const [from, to] = [await this.opened(recipe, source), await this.opened(recipe, target)];
    const counts = [vertexCount(from.model), vertexCount(to.model)] as const;
    const regions = paintedRegions(
      optimalBoundary ?? { sourceRegion: [], feature: [], targetRegion: [] },
      ...counts,
    );
    const args = { source: from.opened.model, target: to.opened.model, regions };
    return this.#session.call('mapRegions', args);
  }

  /**
   * The field of a hair step at every `stride`-th node along each axis, for showing it.
   *
   * @throws LissomError  as `run`; `step-not-found` where the step grows no hair
   */
  hairField(
    recipe: Recipe,
    id: string,
    { stride, signal }: { readonly stride: number; readonly signal?: AbortSignal },
  ): Promise<HairField> {
    return this.#inTurn(async () => {
      const planned = await plan(recipe, this.#source, id);
      const { step, index } = planned.steps.at(-1) ?? {};
      if (step?.type !== 'hair') throw new LissomError('step-not-found', `The step ${id} grows no hair.`);
      return this.#persistently(signal, async () => {
        const stages = this.#stages(recipe, planned);
        const before = { ...planned, steps: planned.steps.slice(0, -1) };
        await this.#run(recipe, before, signal ? { signal } : {}, stages);
        const inputs = [await this.#open(stages.get(step.model)!, signal)];
        const context = { inputs, kernel: this.#session, settle: true, signal, onProgress: () => {} };
        return placed(stepPlace(index!, step), () => hairField(step, context, stride));
      });
    });
  }

  async #run(
    recipe: Recipe,
    { steps, models }: Plan,
    options: RunOptions,
    stages = this.#stages(recipe, { steps, models }),
  ): Promise<Map<string, StepResult>> {
    const { signal, settle = true, measure = false } = options;
    const results = new Map<string, StepResult>();
    for (const [at, { step, index }] of steps.entries()) {
      if (signal?.aborted) throw cancelled();
      const inputs: ModelResult[] = [];
      for (const { name } of referencesOf(step)) inputs.push(await this.#open(stages.get(name)!, signal));
      const onProgress = (fraction: number) => options.onProgress?.((at + fraction) / steps.length, step);
      const context = { inputs, kernel: this.#session, settle, signal, onProgress };
      const place = stepPlace(index, step);
      const key = this.#resultKey(step, inputs, settle);
      const outcome = await placed(place, () =>
        this.#outcome(key, async () => {
          // A plan cannot check what follows a merge: only now are its vertices counted.
          runnerOf(step).check(step, pathText(['steps', index]), shapesOf(step, inputs));
          return runnerOf(step).run(step, context);
        }),
      );
      if (measure && at === steps.length - 1 && sameVertices(outcome.model, inputs[0]!.model))
        await this.#measure(outcome, inputs[0]!, signal);
      stages.set(step.id, { model: outcome.model, key, place });
      results.set(step.id, resultOf(recipe, step, inputs, outcome));
      onProgress(1);
    }
    return results;
  }

  #stages(recipe: Recipe, { models }: Plan): Map<string, Stage> {
    const stages = new Map<string, Stage>();
    for (const [name, model] of models)
      stages.set(name, {
        model,
        key: this.#session.keyOf(model),
        place: modelPlace(name, recipe.models[name]!),
      });
    return stages;
  }

  #open({ model, key, place }: Stage, signal: AbortSignal | undefined): Promise<ModelResult> {
    return placed(place, () => this.#session.open(model, signal, key));
  }

  async #outcome(key: string, run: () => Promise<StepOutcome>): Promise<Cached> {
    const known = this.#results.get(key);
    if (known) return known;
    const outcome: Cached = await run();
    this.#results.set(key, outcome, bytesOf(outcome));
    return outcome;
  }

  async #measure(outcome: Cached, input: ModelResult, signal: AbortSignal | undefined): Promise<void> {
    const { positions } = outcome.model;
    const args = { model: input.opened.model, positions };
    outcome.measured ??= await this.#session.call('measure', args, signal ? { signal } : {});
  }

  /** Models count by identity here: equal geometry may come with other names or colours, which results carry on. */
  #resultKey(step: Step, inputs: readonly ModelResult[], settle: boolean): string {
    const models = inputs.map(({ model, key }) => [key, this.#serial(model)]);
    return hashValue({ type: step.type, settle, models, content: runnerOf(step).content(step) });
  }

  #serial(model: Model): number {
    const serial = this.#serials.get(model) ?? this.#nextSerial++;
    this.#serials.set(model, serial);
    return serial;
  }

  /** Work lost with a worker is done again from the recipe. */
  async #persistently<T>(signal: AbortSignal | undefined, work: () => Promise<T>): Promise<T> {
    for (let attempt = 1; ; attempt++) {
      try {
        return await work();
      } catch (error) {
        const lost = error instanceof LissomError && error.code === 'worker-restarted';
        if (!lost || attempt === ATTEMPTS || signal?.aborted)
          throw signal?.aborted && lost ? cancelled() : error;
      }
    }
  }

  #inTurn<T>(work: () => Promise<T>): Promise<T> {
    const turn = this.#last.then(work);
    this.#last = turn.catch(() => {});
    return turn;
  }
}

const bytesOf = ({ model, strands }: Cached): number =>
  model.positions.byteLength + (strands?.points.byteLength ?? 0) + 1;

const shapesOf = (step: Step, inputs: readonly ModelResult[]): InputShape[] =>
  referencesOf(step).map(({ name }, at) => ({ name, vertices: vertexCount(inputs[at]!.model) }));

/** What a step made anew cannot be measured against what came in. */
const sameVertices = (a: Model, b: Model): boolean => a.positions.length === b.positions.length;

function resultOf(recipe: Recipe, step: Step, inputs: readonly ModelResult[], outcome: Cached): StepResult {
  const { model, strands, figures, seconds, peakBytes, warnings, measured } = outcome;
  // What was found in a model is told by the steps that start from it, not again by those that follow.
  const input = inputs[0]!;
  const found = referencesOf(step).some(({ name }) => Object.hasOwn(recipe.models, name))
    ? input.opened.findings
    : [];
  const report = {
    id: step.id,
    type: step.type,
    vertices: vertexCount(model),
    faces: faceCount(model),
    ...figures,
    seconds,
    peakBytes,
    warnings: [...found, ...warnings],
  };
  return { model, input, inputs, report, ...(strands ? { strands } : {}), ...(measured ? { measured } : {}) };
}
