import { expect, test } from 'vitest';
import { gap } from '../../../web/tools/geometry';
import { PonytailTool, ponytailStage } from '../../../web/tools/hair/ponytail-tool';
import type { Vec3 } from '../../../web/view/types';
import { Chair } from './chair';

/** A tail that stands off the head to the right, seen from the front. */
function built(steps: number) {
  const chair = new Chair();
  const tool = new PonytailTool(chair);
  const strokes = [
    () => chair.stroke(tool, [90, 0], [200, 0]),
    () => chair.stroke(tool, [110, 15], [110, -15]),
    () => chair.stroke(tool, [112, 15], [140, 22], [180, 18]),
    () => chair.stroke(tool, [112, -15], [140, -22], [180, -18]),
  ];
  for (const stroke of strokes.slice(0, steps)) expect(stroke()).toBe(true);
  return { chair, tool };
}

test('four strokes make a ponytail: spine, section, and a profile on either side', () => {
  const { chair } = built(4);
  expect(chair.commits).toEqual(['add-ponytail', 'ponytail-section', 'ponytail-profile', 'ponytail-profile']);
  const { spine, section, profiles, tightness } = chair.step.ponytails[0]!;
  expect(tightness).toBe(0.6);
  expect(spine.length).toBeGreaterThan(6);
  expect(profiles.map((profile) => profile.length > 3)).toEqual([true, true]);
  const middle = [0, 1, 2].map((k) => section.reduce((sum, p) => sum + p[k]!, 0) / section.length);
  expect(gap(middle as unknown as Vec3, [110, 0, middle[2]!])).toBeLessThan(0.1);
  for (const point of section) expect(gap(point, middle as unknown as Vec3)).toBeCloseTo(15, 0);
});

test('each stage follows from what is there, so undo goes back one stroke', () => {
  const stages = [0, 1, 2, 3, 4].map((steps) => ponytailStage(built(steps).chair.scene()));
  expect(stages).toEqual(['spine', 'section', 'profile-0', 'profile-1', 'spine']);
});

test('going back takes away one part at a time, the spine last', () => {
  const { chair, tool } = built(3);
  expect(tool.back()).toBe(true);
  expect(chair.step.ponytails[0]!.profiles[0]).toEqual([]);
  tool.back();
  expect(chair.step.ponytails[0]!.section).toEqual([]);
  tool.back();
  expect(chair.step.ponytails).toEqual([]);
  expect(tool.back()).toBe(false);
});

test('a finished ponytail is not taken apart by going back', () => {
  const { chair, tool } = built(4);
  expect(tool.back()).toBe(false);
  expect(chair.step.ponytails).toHaveLength(1);
});

test('a loop drawn round the spine is a section as wide as the loop', () => {
  const { chair, tool } = built(1);
  chair.stroke(tool, [110, 12], [118, 0], [110, -12], [102, 0], [110, 12]);
  const { section } = chair.step.ponytails[0]!;
  expect(gap(section[0]!, section[4]!) / 2).toBeCloseTo(12, 0);
});

test('away from the spine the camera has the pointer, so that one can turn round it', () => {
  const { chair, tool } = built(1);
  expect(chair.stroke(tool, [110, 140], [150, 150])).toBe(false);
  expect(chair.commits).toEqual(['add-ponytail']);
});

test('a section without width is refused with a word', () => {
  const { chair, tool } = built(1);
  chair.stroke(tool, [110, 0], [125, 0]);
  expect(chair.remarks).toEqual(['tail-too-thin']);
  expect(ponytailStage(chair.scene())).toBe('section');
});

test('with the mirror on both tails are built by one hand', () => {
  const chair = new Chair();
  chair.mirror = true;
  const tool = new PonytailTool(chair);
  chair.stroke(tool, [90, 0], [200, 0]);
  chair.stroke(tool, [110, 15], [110, -15]);
  const [own, twin] = chair.step.ponytails;
  expect(twin!.section).toEqual(own!.section.map(([x, y, z]) => [-x + 0, y, z]));
  expect(ponytailStage(chair.scene())).toBe('profile-0');
});

test('a tail drawn near the middle with the mirror on lies on the middle, and comes alone', () => {
  const chair = new Chair();
  chair.mirror = true;
  chair.side = 'right';
  const tool = new PonytailTool(chair);
  // From the right the head's middle is at its edge: x is up to 25 where the stroke begins.
  chair.stroke(tool, [97, 0], [200, 0]);
  expect(chair.step.ponytails).toHaveLength(1);
  expect(chair.step.ponytails[0]!.spine.every(([x]) => x === 0)).toBe(true);
});
