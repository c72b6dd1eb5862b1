// How the lines of the view are asked for, and drawings of two answers.

import { signal } from '@preact/signals';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { ContoursState } from '../../web/app/curves/contours/state';
import { ViewLines, withFine } from '../../web/app/curves/contours/view-lines';
import type { Evaluation } from '../../web/app/evaluated';
import { Messages } from '../../web/app/messages';
import { State } from '../../web/app/state';
import { LissomError } from '../../web/core/errors';
import type { ContourLines, ContourOptions } from '../../web/kernel/contract/contour';
import type { Recipe } from '../../web/recipe/recipe';
import type { CameraState } from '../../web/view/types';

/** Lines of so many points each; the number of a line is where its points are. */
function linesOf(
  counts: readonly (readonly [points: number, suggestive: 0 | 1])[],
  from = 0,
  seconds = 0,
): ContourLines {
  const numbered = counts.flatMap(([count], i) => new Array<number>(3 * count).fill(from + i));
  const offsets = [0];
  for (const [count] of counts) offsets.push(offsets.at(-1)! + count);
  return {
    points: Float64Array.from(numbered),
    corners: Uint32Array.from(numbered),
    weights: Float32Array.from(numbered),
    offsets: Uint32Array.from(offsets),
    suggestive: Uint8Array.from(counts, ([, flag]) => flag),
    closed: Uint8Array.from(counts, () => 0),
    strength: Float64Array.from(counts, (_, i) => from + i),
    seconds,
  };
}

test('contours of a newer view and the suggestive lines of an older one make one drawing', () => {
  const newer = linesOf([
    [2, 0],
    [3, 0],
    [4, 0],
  ]);
  const older = linesOf(
    [
      [5, 0],
      [2, 1],
      [3, 1],
    ],
    10,
  );
  const { points, offsets, suggestive, strength } = withFine(newer, older);
  expect([...suggestive]).toEqual([0, 0, 0, 1, 1]);
  expect([...offsets]).toEqual([0, 2, 5, 9, 11, 14]);
  expect([...strength]).toEqual([0, 1, 2, 11, 12]);
  expect(points[3 * 9]).toBe(11);
  expect(points.length).toBe(3 * 14);
  expect(withFine(newer, linesOf([[5, 0]]))).toBe(newer);
});

const EMPTY: Recipe = { lissom: 1, models: {}, steps: [], outputs: [] };
const shownWith = (triangles: number, more: Partial<Evaluation> = {}): Evaluation =>
  ({
    recipe: EMPTY,
    step: { id: 's', type: 'curves' },
    shown: {
      opened: { triangles: new Uint32Array(3 * triangles) },
      model: { faceVertices: new Uint32Array() },
    },
    positions: new Float64Array(9),
    settled: true,
    ...more,
  }) as unknown as Evaluation;

interface Call {
  readonly options: ContourOptions;
  readonly eye: readonly number[];
  readonly signal: AbortSignal;
  readonly answer: (seconds?: number) => Promise<void>;
  readonly refuse: (error: Error) => Promise<void>;
}

/** A view, and a worker that answers when it is told to. */
function desk(evaluation: Evaluation) {
  const state = new State({ recipe: EMPTY, selection: { step: 's', item: null } }, 'curves');
  const own = new ContoursState(state, signal(undefined));
  const calls: Call[] = [];
  const ask = (
    _: Recipe,
    __: string,
    ___: string,
    args: never,
    { signal: given }: { signal: AbortSignal },
  ) => {
    const { options, view } = args as { options: ContourOptions; view: { eye: readonly number[] } };
    return new Promise((resolve, reject) => {
      const settled = () => vi.advanceTimersByTimeAsync(0).then(() => {});
      calls.push({
        options,
        eye: view.eye,
        signal: given,
        answer: (seconds = 0.01) => {
          const lines = options.suggestive
            ? ([
                [2, 0],
                [2, 1],
              ] as const)
            : ([[2, 0]] as const);
          resolve(linesOf(lines, 0, seconds));
          return settled();
        },
        refuse: (error) => {
          reject(error);
          return settled();
        },
      });
    });
  };
  const camera = { position: [0, 0, 5], target: [0, 0, 0], orthographic: false } as {
    -readonly [K in keyof CameraState]: CameraState[K];
  };
  const messages = new Messages(state);
  const result = signal<Evaluation | null>(evaluation);
  const parts = { state, messages, runner: { ask } } as unknown as ConstructorParameters<typeof ViewLines>[0];
  const lines = new ViewLines(parts, own, result, () => ({ ...camera }));
  const look = async (x?: number) => {
    if (x !== undefined) camera.position = [x, 0, 5];
    lines.look();
    await vi.advanceTimersByTimeAsync(0);
  };
  return { state, own, calls, camera, result, lines, look };
}

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

test('one view is under way at a time, and of those that wait only the newest is asked for', async () => {
  const { calls, look, own } = desk(shownWith(1));
  await look();
  for (const x of [1, 2, 3]) await look(x);
  expect(calls).toHaveLength(1);
  await calls[0]!.answer();
  expect(own.lines.peek()).not.toBeNull();
  expect(calls.map(({ eye }) => eye[0])).toEqual([0, 3]);
  await calls[1]!.answer();
  await look();
  expect(calls).toHaveLength(2);
});

test('where views are slow only contours follow, and at rest all of it comes again', async () => {
  const { calls, look, own } = desk(shownWith(1));
  await look();
  await calls[0]!.answer(0.2);
  await look(1);
  expect(calls[1]!.options.suggestive).toBe(false);
  await calls[1]!.answer(0.06);
  expect([...own.lines.peek()!.suggestive]).toEqual([0, 1]);
  await vi.advanceTimersByTimeAsync(100);
  expect(calls).toHaveLength(2);
  await vi.advanceTimersByTimeAsync(100);
  expect(calls[2]).toMatchObject({ eye: [1, 0, 5], options: { suggestive: true } });
});

test('a surface that is being pulled waits with its lines until it rests', async () => {
  const { calls, look, state, result } = desk(shownWith(1, { settled: false }));
  await look();
  expect(calls).toEqual([]);
  result.value = shownWith(1);
  state.previewing.value = true;
  await look();
  expect(calls).toEqual([]);
  state.previewing.value = false;
  await look();
  expect(calls).toHaveLength(1);
});

test('without faces there is nothing to ask for, and that is known', async () => {
  const { calls, look, own, result, lines } = desk(shownWith(0));
  await look();
  expect([calls.length, own.problem.peek()]).toEqual([0, 'no-faces']);
  result.value = shownWith(2);
  lines.renew();
  await vi.advanceTimersByTimeAsync(0);
  expect([calls.length, own.problem.peek()]).toEqual([1, null]);
  await calls[0]!.refuse(new LissomError('no-faces', 'none'));
  expect(own.problem.peek()).toBe('no-faces');
});

test('long work shows a way out; stopped, nothing more is asked for until it is wanted again', async () => {
  const { calls, look, own, state } = desk(shownWith(1));
  await look();
  await vi.advanceTimersByTimeAsync(300);
  state.busy.peek()!.cancel!();
  expect([calls[0]!.signal.aborted, own.problem.peek()]).toEqual([true, 'stopped']);
  await calls[0]!.answer();
  expect([own.lines.peek(), state.busy.peek()]).toEqual([null, null]);
  await look(1);
  expect(calls).toHaveLength(1);
  own.problem.value = null;
  await look();
  expect(calls).toHaveLength(2);
});

test('what fails is said once and does not go on failing', async () => {
  const { calls, look, own, state } = desk(shownWith(1));
  await look();
  await calls[0]!.refuse(new Error('gone'));
  expect(own.problem.peek()).toBe('failed');
  expect(state.toasts.peek()).toHaveLength(1);
  await look(1);
  expect(calls).toHaveLength(1);
});
