import type { Step, StepOf, StepType } from '../../recipe/recipe';
import type { Capacities } from '../session';
import { blendRunner } from './blend';
import { curvesRunner } from './curves';
import { deformRunner } from './deform';
import { dressRunner } from './dress';
import { hairRunner } from './hair';
import { matchRunner } from './match';
import { mergeRunner } from './merge';
import type { StepContext, StepRunner } from './step-runner';
import { transferRunner } from './transfer';

/** One line per step type: the registry of this floor. */
const runners = {
  deform: deformRunner,
  merge: mergeRunner,
  hair: hairRunner,
  transfer: transferRunner,
  curves: curvesRunner,
  match: matchRunner,
  blend: blendRunner,
  dress: dressRunner,
} satisfies { readonly [T in StepType]: StepRunner<StepOf<T>> };

export const runnerOf = (step: Step): StepRunner<Step> => runners[step.type] as StepRunner<Step>;

export const capacities: Capacities = Object.assign(
  {},
  ...Object.values<StepRunner<never>>(runners).map(({ keeps }) => keeps),
);

type Runners = typeof runners;

/** What a step type adds to its line of the report. */
export type FiguresOf<T extends StepType> = Awaited<ReturnType<Runners[T]['run']>>['figures'];

type QuestionsOf<T extends StepType> = Runners[T] extends { readonly questions: infer Q } ? Q : object;
type Answers<Q> = {
  [T in StepType]: Q extends keyof QuestionsOf<T> ? QuestionsOf<T>[Q] : never;
}[StepType];

/** Names of all that may be asked of steps. */
export type Question = { [T in StepType]: keyof QuestionsOf<T> & string }[StepType];
export type QuestionArgs<Q extends Question> =
  Answers<Q> extends (step: never, context: StepContext, args: infer A) => unknown ? A : never;
export type Answer<Q extends Question> =
  Answers<Q> extends (step: never, context: StepContext, args: never) => Promise<infer R> ? R : never;
