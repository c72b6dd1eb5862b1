// Recipes run by the real kernel on small models, whole ones and broken ones.

import type { Model } from '../../web/core/model';
import type { Args, CallOptions, KernelPort, Method, Result } from '../../web/kernel/contract';
import type { KernelId } from '../../web/kernel/contract/model';
import { loadKernel } from '../../web/kernel/node';
import { parseRecipe } from '../../web/recipe/parse';
import { Runner } from '../../web/run/evaluate';
import { type Generator, must, outcomeOf } from './generator';
import { mutateJson, tweakJson } from './mutate';
import type { Random } from './random';

/** How a step type is tried: its wing registers it by a file in `generators/`. */
export interface KernelTrial {
  readonly kind: string;
  readonly every: number;
  /** Valid; changed in a few places for most inputs. */
  readonly recipe: object;
  /** By the names that the recipe has for them. */
  readonly models: Readonly<Record<string, Model>>;
}

let kernel: Promise<CountedKernel> | undefined;

export function kernelGenerator(trial: KernelTrial): Generator {
  const { kind, every } = trial;
  let calls = 0;
  return {
    kind,
    every,
    calls: () => calls,
    show(random) {
      const { recipe, damage } = inputOf(random, trial);
      return `${[...damage].map(([name, done]) => `${name}: ${done.join(', ') || 'whole'}`).join('\n')}\n${JSON.stringify(recipe)}`;
    },
    async run(random) {
      kernel ??= loadKernel().then((port) => new CountedKernel(port));
      const counted = await kernel;
      const before = counted.calls;
      const { recipe, models } = inputOf(random, trial);
      const source = { load: async (name: string) => models.get(name) ?? [...models.values()][0]! };
      try {
        return await outcomeOf(async () => {
          const results = await new Runner({ kernel: counted, models: source }).run(parseRecipe(recipe));
          for (const { model, strands, inputs } of results.values()) {
            checkFinite(
              model.positions,
              inputs.map((input) => input.model.positions),
            );
            must(!strands?.points.some((x) => !Number.isFinite(x)), 'a strand that is no place');
          }
        });
      } finally {
        calls += counted.calls - before;
        await counted.releaseAll();
      }
    },
  };
}

interface KernelInput {
  readonly recipe: unknown;
  readonly models: ReadonlyMap<string, Model>;
  /** What was done to each model. */
  readonly damage: ReadonlyMap<string, readonly string[]>;
}

function inputOf(random: Random, { recipe, models }: KernelTrial): KernelInput {
  if (random.chance(0.1)) return { recipe, models: new Map(Object.entries(models)), damage: new Map() };
  const damage = new Map<string, string[]>();
  const broken = new Map<string, Model>();
  for (const [name, model] of Object.entries(models)) {
    const done: string[] = [];
    damage.set(name, done);
    broken.set(name, random.chance(0.5) ? model : brokenModel(random, model, done));
  }
  const changed = random.chance(0.2) ? mutateJson(random, recipe, 1) : tweakJson(random, recipe);
  return { recipe: changed, models: broken, damage };
}

/** Only what was not finite may not be. */
function checkFinite(positions: Float64Array, inputs: readonly Float64Array[]): void {
  const bad = positions.findIndex((x) => !Number.isFinite(x));
  if (bad < 0) return;
  must(
    inputs.some((rest) => rest.some((x) => !Number.isFinite(x))),
    `coordinate ${bad} became ${positions[bad]}`,
  );
}

/** Moved, scaled, with faces or coordinates that are none. */
function brokenModel(random: Random, model: Model, done: string[]): Model {
  const positions = model.positions.slice();
  const faceVertices = model.faceVertices.slice();
  for (let i = random.few(4); i > 0; i--)
    switch (random.below(5)) {
      case 0: {
        const by = random.pick([0, 1e-30, 1e-9, 1e9, 1e30, 1e100]);
        for (let k = 0; k < positions.length; k++) positions[k]! *= by;
        done.push(`times ${by}`);
        break;
      }
      case 1: {
        const by = random.pick([1, 1e6, 1e12]);
        for (let k = 0; k < positions.length; k++) positions[k]! += by;
        done.push(`moved by ${by}`);
        break;
      }
      case 2: {
        const [k, to] = [random.below(positions.length), random.pick([NaN, Infinity, 1e30, -1e300, 0])];
        positions[k] = to;
        done.push(`coordinate ${k} = ${to}`);
        break;
      }
      case 3: {
        const [k, to] = [
          random.below(faceVertices.length),
          random.pick([0, 1, 2 ** 32 - 1, positions.length]),
        ];
        faceVertices[k] = to;
        done.push(`corner ${k} = ${to}`);
        break;
      }
      default: {
        const [from, to] = [random.below(positions.length / 3), random.below(positions.length / 3)];
        positions.copyWithin(3 * to, 3 * from, 3 * from + 3);
        done.push(`vertex ${to} on ${from}`);
      }
    }
  return { ...model, positions, faceVertices };
}

const isHeld = (answer: unknown): answer is { readonly id: KernelId } =>
  typeof answer === 'object' && answer !== null && 'id' in answer;

class CountedKernel implements KernelPort {
  calls = 0;
  /** What the kernel holds: a trial leaves nothing to the next one. */
  readonly #held = new Set<KernelId>();

  constructor(private readonly port: KernelPort) {}

  get epoch(): number {
    return this.port.epoch;
  }

  async call<M extends Method>(method: M, args: Args<M>, options?: CallOptions): Promise<Result<M>> {
    this.calls++;
    const answer = await this.port.call(method, args, options);
    if (method === 'release') this.#held.delete((args as Args<'release'>).id);
    else if (isHeld(answer)) this.#held.add(answer.id);
    return answer;
  }

  async releaseAll(): Promise<void> {
    for (const id of this.#held) await this.port.call('release', { id });
    this.#held.clear();
  }
}
