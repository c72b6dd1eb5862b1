// Recipe -> results: a pure function of the recipe and its models, with caches that only save time.

import { cancelled, LissomError } from '../core/errors';
import { hashValue } from '../core/hash';
import { Lru } from '../core/lru';
import { type Model, vertexCount } from '../core/model';
import type { KernelPort, Look } from '../kernel/contract';
import type { Measured } from '../kernel/contract/model';
import { pathText } from '../recipe/problem';
import type { Recipe, Step } from '../recipe/recipe';
import { outputName, producedNames, referencesOf } from '../recipe/references';
import { modelPlace, type Plan, plan, stepPlace } from './plan';
import { mainOf, resultOf, type StepResult } from './results';
import { KernelSession } from './session';
import { type Answer, capacities, type Question, type QuestionArgs, runnerOf } from './steps/all';
import type { InputShape, Origin, Preparation, StepContext, StepOutcome } from './steps/step-runner';
import { type ModelResult, type ModelSource, placed } from './types';

export interface RunOptions {
  /** Id of the last step wanted; only what it depends on is run. All steps when left out. */
  readonly until?: string;
  readonly signal?: AbortSignal;
  /** @param fraction  of all steps, in [0, 1]; @param step  the one under way */
  readonly onProgress?: (fraction: number, step: Step) => void;
  /** Hears of what takes much memory before it starts. */
  readonly onPreparation?: (preparation: Preparation, step: Step) => void;
  /** Sees what a step under way makes grow. */
  readonly onLook?: (look: Look, step: Step) => void;
  /** False: quick previews will do. */
  readonly settle?: boolean;
  /** Also measure what the last step did to the model that it changes. */
  readonly measure?: boolean;
}

export interface AskOptions extends Pick<RunOptions, 'signal'> {
  /** @param fraction  in [0, 1] */
  readonly onProgress?: (fraction: number) => void;
  readonly onPreparation?: (preparation: Preparation) => void;
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
  readonly origin?: Origin;
}

/** Opened models, and where they come from. */
type Given = Pick<StepContext, 'inputs' | 'origins'>;

export class Runner {
  readonly #source: ModelSource;
  readonly #session: KernelSession;
  readonly #results = new Lru<Cached>(RESULT_BYTES);
  readonly #serials = new WeakMap<Model, number>();
  #nextSerial = 1;
  #last: Promise<unknown> = Promise.resolve();

  constructor({ kernel, models }: { readonly kernel: KernelPort; readonly models: ModelSource }) {
    this.#source = models;
    this.#session = new KernelSession(kernel, capacities);
  }

  /**
   * The results of the steps asked for and of those they depend on, by step id. Runs asked for at the same time
   * follow each other.
   *
   * @throws LissomError  the user's (`index-out-of-range`, what readers and kernel refuse), the machine's, `cancelled`;
   *                      as a PlacedError where a step or model is to blame
   */
  run(recipe: Recipe, options: RunOptions = {}): Promise<Map<string, StepResult>> {
    const { until, signal } = options;
    return this.#inTurn(signal, async () => {
      const planned = await plan(recipe, this.#source, until === undefined ? until : [until]);
      return this.#persistently(signal, () => this.#run(recipe, planned, options));
    });
  }

  /** The opened model under a name: one of the recipe's models, or what a step leaves. */
  async opened(recipe: Recipe, name: string, { signal }: AskOptions = {}): Promise<ModelResult> {
    const [only] = await this.#inTurn(signal, () =>
      this.#with(recipe, [name], signal, async ({ inputs }) => inputs),
    );
    return only!;
  }

  /** The opened models that a step starts from, in the order of its references; the step itself is not run. */
  inputs(recipe: Recipe, id: string, { signal }: AskOptions = {}): Promise<readonly ModelResult[]> {
    return this.#inTurn(signal, () =>
      this.#with(recipe, inputNames(recipe, id), signal, async ({ inputs }) => inputs),
    );
  }

  /**
   * What a step's type lets be asked of it beside its result; the step itself is not run.
   *
   * @throws LissomError  as `run`; `step-not-found` where there is no such step, or its type knows no such question
   */
  ask<Q extends Question>(
    recipe: Recipe,
    id: string,
    question: Q,
    args: QuestionArgs<Q>,
    { signal, onProgress = () => {}, onPreparation = () => {} }: AskOptions = {},
  ): Promise<Answer<Q>> {
    return this.#inTurn(signal, () =>
      this.#with(recipe, inputNames(recipe, id), signal, (given) => {
        const index = recipe.steps.findIndex((step) => step.id === id);
        const step = recipe.steps[index]!;
        const answer = runnerOf(step).questions?.[question];
        if (!answer) throw notFound(`The ${step.type} step ${JSON.stringify(id)} knows no ${question}.`);
        const context = {
          ...given,
          kernel: this.#session,
          settle: true,
          signal,
          onProgress,
          onLook: undefined,
          onPreparation,
        };
        return placed(
          stepPlace(index, step),
          () => answer(step, context, args as never) as Promise<Answer<Q>>,
        );
      }),
    );
  }

  /** Does some work with opened models, once what they depend on has run. */
  async #with<T>(
    recipe: Recipe,
    names: readonly string[],
    signal: AbortSignal | undefined,
    work: (given: Given) => Promise<T>,
  ): Promise<T> {
    const planned = await plan(recipe, this.#source, names);
    return this.#persistently(signal, async () => {
      const stages = this.#stages(recipe, planned);
      await this.#run(recipe, planned, signal ? { signal } : {}, stages);
      return work(await this.#open(stages, names, signal));
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
      const names = referencesOf(step).map(({ name }) => name);
      const given = await this.#open(stages, names, signal);
      const { inputs } = given;
      const onProgress = (fraction: number) => options.onProgress?.((at + fraction) / steps.length, step);
      const onPreparation = (preparation: Preparation) => options.onPreparation?.(preparation, step);
      const look = options.onLook;
      const onLook = look && ((seen: Look) => look(seen, step));
      const context = { ...given, kernel: this.#session, settle, signal, onProgress, onLook, onPreparation };
      const place = stepPlace(index, step);
      const key = this.#resultKey(step, given, settle);
      const runner = runnerOf(step);
      const outcome = await placed(place, () =>
        this.#outcome(key, async () => {
          // A plan cannot check what follows a step that makes a new surface: only now are its vertices counted.
          runner.check(step, pathText(['steps', index]), shapesOf(step, given));
          return runner.run(step, context);
        }),
      );
      if (measure && at === steps.length - 1) await this.#measure(outcome, mainOf(step, inputs), signal);
      for (const [name, stage] of stagesOf(step, outcome, {
        key,
        place,
        origin: { step, inputs, models: outcome.models },
      }))
        stages.set(name, stage);
      const finished = runner.finish?.(step, outcome) ?? outcome;
      results.set(step.id, resultOf(recipe, step, inputs, finished, outcome.measured));
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

  async #open(
    stages: ReadonlyMap<string, Stage>,
    names: readonly string[],
    signal: AbortSignal | undefined,
  ): Promise<Given> {
    const inputs: ModelResult[] = [];
    const named = names.map((name) => stages.get(name)!);
    for (const { model, key, place } of named)
      inputs.push(await placed(place, () => this.#session.open(model, signal, key)));
    return { inputs, origins: named.map(({ origin }) => origin) };
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
    // What a step made anew cannot be measured against what came in.
    if (positions.length !== input.model.positions.length) return;
    const args = { model: input.opened.id, positions };
    outcome.measured ??= await this.#session.call('measure', args, signal ? { signal } : {});
  }

  /** Models count by identity here: equal geometry may come with other names or colours, which results carry on. */
  #resultKey(step: Step, { inputs, origins }: Given, settle: boolean): string {
    const models = inputs.map(({ model, key }) => [key, this.#serial(model)]);
    const content = runnerOf(step).content(
      step,
      origins.map((origin) => origin?.step),
    );
    return hashValue({ type: step.type, settle, models, content });
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

  #inTurn<T>(signal: AbortSignal | undefined, work: () => Promise<T>): Promise<T> {
    const turn = this.#last.then(() => {
      if (signal?.aborted) throw cancelled();
      return work();
    });
    this.#last = turn.catch(() => {});
    return turn;
  }
}

const notFound = (message: string): LissomError => new LissomError('step-not-found', message);

const shapesOf = (step: Step, { inputs, origins }: Given): InputShape[] =>
  referencesOf(step).map(({ name }, at) => ({
    name,
    vertices: vertexCount(inputs[at]!.model),
    maker: origins[at]?.step,
  }));

function inputNames(recipe: Recipe, id: string): readonly string[] {
  const step = recipe.steps.find((each) => each.id === id);
  if (!step) throw notFound(`There is no step ${JSON.stringify(id)} in the recipe.`);
  return referencesOf(step).map(({ name }) => name);
}

const bytesOf = ({ model, models = { model }, strands }: Cached): number =>
  Object.values(models).reduce((sum, { positions }) => sum + positions.byteLength, 1) +
  (strands?.points.byteLength ?? 0);

/** What later steps find under the step's names; by its id that is the model in the place of its main input. */
function* stagesOf(
  step: Step,
  { model, models }: StepOutcome,
  { key, ...rest }: Omit<Stage, 'model'>,
): Iterable<[string, Stage]> {
  yield [step.id, { model, key, ...rest }];
  for (const name of models ? producedNames(step) : [])
    yield [
      name,
      { model: models![outputName(step, name)]!, key: `${key}/${outputName(step, name)}`, ...rest },
    ];
}
