import { expect, test } from 'vitest';
import { type Curve, type CurvesStep, newCurvesStep } from '../../web/recipe/steps/curves';
import * as edits from '../../web/recipe/steps/curves-edits';
import * as poses from '../../web/recipe/steps/curves-poses';

const line = (id: string, x: number): Curve => ({
  id,
  kind: 'skeleton',
  rest: [
    [x, 0, 0],
    [x, 1, 0],
    [x, 2, 0],
  ],
});
const STEP: CurvesStep = {
  ...newCurvesStep('pose', 'm'),
  curves: [line('a', 0), line('b', 1), line('c', 2)],
  links: [{ child: 'b', parent: 'a', at: 1 }],
};

test('a link that would close a ring is not made, however long the ring', () => {
  const chain = edits.linkCurves(STEP, { child: 'c', parent: 'b', at: 0 });
  expect(chain.links).toHaveLength(2);
  expect(edits.linkCurves(chain, { child: 'a', parent: 'c', at: 0 })).toBe(chain);
  expect(edits.linkCurves(chain, { child: 'a', parent: 'a', at: 0 })).toBe(chain);
});

test('a curve hangs on one other: a second link takes the place of the first', () => {
  expect(edits.linkCurves(STEP, { child: 'b', parent: 'c', at: 0.5 }).links).toEqual([
    { child: 'b', parent: 'c', at: 0.5 },
  ]);
});

test('a removed curve takes its links and its part of every pose along', () => {
  const bent = edits.updateCurve(STEP, 'b', { twist: [0, 0, 30] });
  const left = edits.removeCurve(poses.addPose(bent, 'Bent'), 'b');
  expect(left.curves.map(({ id }) => id)).toEqual(['a', 'c']);
  expect([left.links, left.poses[0]!.curves]).toEqual([[], []]);
});

test('a renamed curve is renamed wherever it is named, and never to a name that is taken', () => {
  const bent = poses.addPose(edits.updateCurve(STEP, 'b', { twist: [0, 0, 30] }), 'Bent');
  const renamed = edits.renameCurve(bent, 'b', 'arm');
  expect(renamed.links[0]).toEqual({ child: 'arm', parent: 'a', at: 1 });
  expect(renamed.poses[0]!.curves[0]!.id).toBe('arm');
  expect(edits.renameCurve(bent, 'b', 'a')).toBe(bent);
});

test('reset leaves nothing of a posture, and a step at rest as it is', () => {
  const bent = edits.updateCurve(STEP, 'a', { twist: [0, 0, 9], base: [0, 0, 1, 1], scale: [] });
  expect(edits.resetCurves(bent)).toEqual(STEP);
  expect(edits.resetCurves(STEP)).toBe(STEP);
});

test('a pose that is taken up again gives back what was kept', () => {
  const bent = edits.updateCurve(STEP, 'a', { posed: STEP.curves[1]!.rest, twist: [0, 5, 9] });
  const kept = poses.addPose(bent, 'Bent');
  const back = poses.takePose(edits.resetCurves(kept), kept.poses[0]!);
  expect(back.curves).toEqual(bent.curves);
  expect(poses.standsIn(back, kept.poses[0]!)).toBe(true);
  expect(poses.standsIn(edits.resetCurves(back), kept.poses[0]!)).toBe(false);
});

test('between two poses a limb swings without getting shorter, and both ends are met', () => {
  const up = poses.poseOf(STEP, 'Up');
  const across: Curve['rest'] = [
    [0, 0, 0],
    [1, 0, 0],
    [2, 0, 0],
  ];
  const side = poses.poseOf(edits.updateCurve(STEP, 'a', { posed: across, base: [0, 0, -1, 1] }), 'Side');
  for (const t of [0.25, 0.5, 0.75]) {
    const { posed, base } = poses.betweenPoses(STEP, up, side, t).curves[0]!;
    const [p, , r] = posed!;
    expect(Math.hypot(r![0] - p![0], r![1] - p![1])).toBeCloseTo(2, 12);
    const angle = (t * Math.PI) / 2;
    expect(r![0]).toBeCloseTo(2 * Math.sin(angle), 12);
    expect(base![2]).toBeCloseTo(-Math.sin(angle / 2), 12);
  }
  expect(poses.betweenPoses(STEP, up, side, 1).curves[0]!.posed).toBe(across);
  expect(poses.betweenPoses(STEP, up, side, 0).curves[0]!.posed).toBeUndefined();
});

test('poses begin when they say, and a last one like the first closes the round without a pause', () => {
  const pose = (name: string, twist: number[], time?: number) => ({
    name,
    curves: [{ id: 'a', twist }],
    ...(time !== undefined && { time }),
  });
  const [one, two] = [pose('One', [0, 0, 9]), pose('Two', [0, 0, 20], 0.3)];
  expect(poses.beginnings([one, two])).toEqual([0, 0.3, 1.1]);
  expect(poses.beginnings([one, two, pose('Three', [0, 0, 30], 0.6)])).toEqual([0, 0.3, 0.6, 1.4]);
  expect(poses.beginnings([one, two, pose('One again', [0, 0, 9], 0.6)])).toEqual([0, 0.3, 0.6, 0.6]);
  expect(poses.beginnings([one, pose('One again', [0, 0, 9], 0.3)])).toEqual([0, 0.3, 1.1]);
});
