import { expect, test, vi } from 'vitest';
import type { Quaternion } from '../../../web/core/quaternion';
import { type Curve, type CurvesStep, newCurvesStep } from '../../../web/recipe/steps/curves';
import * as edits from '../../../web/tools/curves/edits';
import { GuardedEdit } from '../../../web/tools/curves/guarded-edit';
import type { CurvesEdit, CurvesHost } from '../../../web/tools/curves/host';
import { gripOf, itemOf } from '../../../web/tools/curves/items';
import { PIECES, splineAt, splinePoints } from '../../../web/tools/curves/spline';
import type { Vec3 } from '../../../web/view/types';

const SIZE = 4;
const line = (id: string, ...rest: Curve['rest']): Curve => ({ id, kind: 'skeleton', rest });
const TRUNK = line('trunk', [0, 0, 0], [0, 1, 0], [0, 2, 0]);
const ARM = line('arm', [0.1, 2, 0], [1, 2, 0], [2, 2, 0]);
const STEP: CurvesStep = { ...newCurvesStep('pose', 'm'), curves: [TRUNK, ARM] };

test('a number stands for a curve or one of its control points, and back', () => {
  for (const grip of [
    { curve: 0, point: null },
    { curve: 0, point: 0 },
    { curve: 7, point: 199 },
    { curve: 8, point: null },
  ])
    expect(gripOf(itemOf(grip))).toEqual(grip);
});

test('the drawn line passes through the control points and is straight where they are', () => {
  const points: Vec3[] = [
    [0, 0, 0],
    [1, 0, 0],
    [4, 0, 0],
    [4, 2, 1],
  ];
  const drawn = splinePoints(points);
  points.forEach((point, i) => {
    expect(drawn[i * PIECES]).toEqual(point);
  });
  for (const [, y, z] of drawn.slice(0, PIECES)) expect([y, z]).toEqual([0, 0]);
  expect(splineAt(points, -0.1)[0]).toBeCloseTo(-0.3, 12);
});

test('a moved point moves alone; back at rest nothing is left of it', () => {
  const moved = edits.movePoint(STEP, { curve: 0, point: 2 }, [1, 2, 0], SIZE);
  expect(moved.curves[0]!.posed).toEqual([
    [0, 0, 0],
    [0, 1, 0],
    [1, 2, 0],
  ]);
  expect(edits.movePoint(moved, { curve: 0, point: 2 }, [0, 2, 0], SIZE).curves[0]).toEqual(TRUNK);
});

test('a turn at a joint moves what lies beyond it, seen from the end that stays', () => {
  const quarter: Quaternion = [0, 0, -Math.SQRT1_2, Math.SQRT1_2];
  const turned = edits.turnFrom(STEP, { curve: 0, point: 1 }, quarter, 'start', SIZE).curves[0]!;
  expect(turned.posed![2]).toEqual([1, 1, 0]);
  expect(turned.posed![0]).toEqual([0, 0, 0]);
  expect([turned.base, turned.twist]).toEqual([undefined, undefined]);
  const other = edits.turnFrom(STEP, { curve: 0, point: 1 }, quarter, 'end', SIZE).curves[0]!;
  expect(other.posed![0]).toEqual([-1, 1, 0]);
});

test('a turn of the end that stays turns the whole curve, and says so', () => {
  const quarter: Quaternion = [0, 0, -Math.SQRT1_2, Math.SQRT1_2];
  const { posed, base } = edits.turnFrom(STEP, { curve: 0, point: null }, quarter, 'start', SIZE).curves[0]!;
  expect(posed![2]).toEqual([2, 0, 0]);
  expect(base![2]).toBeCloseTo(-Math.SQRT1_2, 8);
});

test('a turn about the curve itself is twist', () => {
  const half: Quaternion = [0, Math.sin(Math.PI / 6), 0, Math.cos(Math.PI / 6)];
  const { posed, twist } = edits.turnFrom(STEP, { curve: 0, point: 1 }, half, 'start', SIZE).curves[0]!;
  expect(posed).toBeUndefined();
  expect(twist).toEqual([0, 60, 60]);
});

test('a stroke that ends on a control point hangs there and begins there, whichever way it was drawn', () => {
  const bare = { ...STEP, curves: [TRUNK] };
  for (const points of [ARM.rest, ARM.rest.toReversed()]) {
    const { step, curve } = edits.addDrawn(bare, 'skeleton', points, {
      name: 'curve',
      near: 0.2,
      size: SIZE,
    });
    expect(curve).toBe(1);
    expect(step.links).toEqual([{ child: 'curve 1', parent: 'trunk', at: 1 }]);
    expect(step.curves[1]).toMatchObject({ anchor: 'start', rest: [[0, 2, 0], ARM.rest[1], ARM.rest[2]] });
    expect(edits.jointOf(step, 1)).toEqual({ curve: 0, point: 2 });
  }
  const far = edits.addDrawn(bare, 'skeleton', ARM.rest, { name: 'curve', near: 0.05, size: SIZE });
  expect(far.step.links).toEqual([]);
});

test('a mirrored curve hangs on the same parent, and mirrored twice it is itself', () => {
  const linked = edits.linkAt(STEP, { curve: 1, point: 0 }, { curve: 0, point: 2 });
  const bent = edits.setTwist(linked, { curve: 1, point: 2 }, 30);
  const both = edits.mirrorCurve(bent, 1, 'curve');
  expect(both.curves[2]).toMatchObject({
    id: 'curve 1',
    rest: [
      [0, 2, 0],
      [-1, 2, 0],
      [-2, 2, 0],
    ],
  });
  expect(both.curves[2]!.twist).toEqual([0, 0, -30]);
  expect(both.links[1]).toEqual({ child: 'curve 1', parent: 'trunk', at: 1 });
  const again = edits.mirrorCurve(both, 2, 'curve').curves[3]!;
  expect({ ...again, id: 'arm' }).toEqual(both.curves[1]);
});

test('a twist or a width fades over the neighbours, as many as wanted', () => {
  const points = [0, 1, 2, 3, 4].map((y): [number, number, number] => [0, y, 0]);
  const five = { ...STEP, curves: [{ id: 'limb', kind: 'skeleton' as const, rest: points }] };
  const middle = { curve: 0, point: 2 };
  const twisted = (range: number, point = 2) =>
    edits.setTwist(five, { curve: 0, point }, 12, range).curves[0]!.twist;
  expect(twisted(0)).toEqual([0, 0, 12, 0, 0]);
  expect(twisted(1)).toEqual([0, 6, 12, 6, 0]);
  expect(twisted(2, 0)).toEqual([12, 8, 4, 0, 0]);
  // From there it goes on by what is missing.
  const again = edits.setTwist(edits.setTwist(five, middle, 12, 1), middle, 20, 0);
  expect(again.curves[0]!.twist).toEqual([0, 6, 20, 6, 0]);
  // Widths multiply: at half the share it is the root.
  const wide = edits.setScale(five, middle, [4, 1], 1).curves[0]!.scale!;
  expect(wide.map(([x]) => x)).toEqual([1, 2, 4, 2, 1]);
  expect(wide.every(([, y]) => y === 1)).toBe(true);
});

test('an end moves along its curve, inwards or straight on', () => {
  expect(edits.moveEnd(STEP, 0, 'end', 0.5, SIZE).curves[0]!.rest.at(-1)).toEqual([0, 1, 0]);
  expect(edits.moveEnd(STEP, 0, 'start', -0.5, SIZE).curves[0]!.rest[0]).toEqual([0, -1, 0]);
});

/** A host whose surface lets drags go half the way. */
function guarded(share: () => Promise<number>) {
  const shown: CurvesEdit[] = [];
  const committed: [string, CurvesEdit][] = [];
  const stopped: boolean[] = [];
  const host = {
    preview: (edit: CurvesEdit) => void shown.push(edit),
    commit: (label: string, edit: CurvesEdit) => void committed.push([label, edit]),
    cancel: vi.fn(),
    share,
    showStopped: (is: boolean) => void stopped.push(is),
    failed: vi.fn(),
  };
  return { host: host as unknown as CurvesHost, cancel: host.cancel, shown, committed, stopped };
}

const GRIP = { curve: 0, point: 2 };
const pulled = edits.movePoint(STEP, GRIP, [1, 2, 0], SIZE);

test('a drag goes as far as the surface lets it, says so, and is committed once', async () => {
  const { host, committed, stopped } = guarded(async () => 0.5);
  const edit = new GuardedEdit(host, STEP, GRIP);
  edit.offer(() => pulled);
  edit.finish('move');
  await vi.waitFor(() => expect(committed).toHaveLength(1));
  expect(committed[0]![0]).toBe('move');
  expect(committed[0]![1].step.curves[0]!.posed![2]).toEqual([0.5, 2, 0]);
  expect(stopped).toEqual([true, false]);
});

test('of wishes that come while one is looked at only the newest is', async () => {
  const asked: number[] = [];
  const { host, shown } = guarded(async () => 1);
  const edit = new GuardedEdit(host, STEP, GRIP);
  for (const x of [1, 2, 3, 4])
    edit.offer(() => {
      asked.push(x);
      return pulled;
    });
  await vi.waitFor(() => expect(shown).toHaveLength(2));
  expect(asked).toEqual([1, 4]);
});

test('a cancelled drag leaves no trace, even while it is being looked at', async () => {
  let answer = (_: number): void => {};
  const { host, cancel, shown, committed } = guarded(
    () =>
      new Promise((resolve) => {
        answer = resolve;
      }),
  );
  const edit = new GuardedEdit(host, STEP, GRIP);
  edit.offer(() => pulled);
  await Promise.resolve();
  await Promise.resolve();
  edit.cancel();
  answer(1);
  await new Promise((resolve) => setTimeout(resolve));
  expect([shown, committed]).toEqual([[], []]);
  expect(cancel).toHaveBeenCalledOnce();
});
