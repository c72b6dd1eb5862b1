// A matrix of 1e308 ended in results that were no numbers, a hair volume of 1e300 likewise; a parting that led a billion
// kilometres away was sampled at the size of the head's grid and never ended.

import { expect, test } from 'vitest';
import { parseRecipe } from '../../web/recipe/parse';
import { checkReach } from '../../web/run/steps/hair/reach';
import { makeModel } from '../io/support';
import { refusal } from './bounded';

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const recipe = (step: object, models: object = { m: { builtin: 'bar' } }, outputs: object[] = []) => ({
  lissom: 1,
  models,
  steps: [{ id: 's', model: 'm', ...step }],
  outputs,
});
const region = (matrix: number[]) => ({ kind: 'region', vertices: [0], matrix });
const moved = (by: number) => region([...IDENTITY.slice(0, 12), by, 0, 0, 1]);
const deform = (handles: object[], method = 'naive') => recipe({ type: 'deform', method, handles });
const hair = (fields: object) => recipe({ type: 'hair', ...fields });
const merge = (fields: object) => ({
  ...recipe({}),
  steps: [{ id: 's', type: 'merge', source: 'm', target: 'm', ...fields }],
});

test.each([
  [
    'a naive target of 1e308',
    deform([moved(1e308)]),
    'steps[0].handles[0].matrix[12]: expected a number from -1e+30 to 1e+30, found 1e+308.',
  ],
  [
    'a matrix of 1e300',
    deform([region(IDENTITY.map((x) => x * 1e300))]),
    'steps[0].handles[0].matrix[0]: expected a number from -1e+30 to 1e+30, found 1e+300',
  ],
  [
    'a point at infinity',
    deform([{ kind: 'point', vertices: [0], position: [0, Number.POSITIVE_INFINITY, 0] }]),
    'steps[0].handles[0].position[1]: expected a number from -1e+30 to 1e+30, found Infinity.',
  ],
  ['an index of 1e300', deform([{ ...region(IDENTITY), vertices: [1e300] }]), 'steps[0].handles[0].vertices'],
  [
    'a volume of 1e300',
    hair({ volume: 1e300 }),
    'steps[0].volume: expected a number from 0 to 1e+30, found 1e+300.',
  ],
  [
    'a length of 1e300',
    hair({ length: { max: 1e300 } }),
    'steps[0].length.max: expected a number above 0, up to 1e+30, found 1e+300.',
  ],
  [
    'a stroke at 1e300',
    hair({ streams: [{ points: [[0, 0, 1e300]] }] }),
    'steps[0].streams[0].points[0][2]: expected a number from -1e+30 to 1e+30',
  ],
  [
    'a transition of weight 1e300',
    merge({ transition: { sourceWidth: 1, targetWidth: 1, weight: 1e300 } }),
    'steps[0].transition.weight: expected a number from 0 to 1000000000, found 1e+300.',
  ],
  [
    'a placement scaled 1e300 times',
    merge({
      optimalBoundary: {
        sourceRegion: [],
        feature: [],
        targetRegion: [],
        placement: { shift: [0, 0], turn: 0, scale: 1e300 },
      },
    }),
    'steps[0].optimalBoundary.placement.scale: expected a number above 0, up to 1000000000',
  ],
  [
    'more handles than there are roles for',
    deform(Array.from({ length: 1001 }, () => moved(0))),
    'steps[0].handles: expected a list of at most 1,000, found a list of 1001.',
  ],
])('%s is refused with its place', (what, document, expected) => {
  const { code, message } = refusal(what, () => parseRecipe(document));
  expect(code).toBe('recipe-invalid');
  expect(message).toContain(expected);
});

test('a parting that leads out of reach is refused before it is sampled', () => {
  const head = makeModel([0, 0, 0, 1, 0, 0, 0, 1, 0], [[0, 1, 2]]);
  const step = (x: number) => {
    const { steps } = parseRecipe(
      hair({
        partings: [
          {
            points: [
              [0, 0, 0],
              [x, 0, 0],
            ],
          },
        ],
      }),
    );
    return steps[0] as Parameters<typeof checkReach>[0];
  };
  expect(() => checkReach(step(5), head)).not.toThrow();
  const { code, message } = refusal('a parting of 1e12', () => checkReach(step(1e12), head));
  expect(code).toBe('stroke-too-far');
  expect(message).toBe(
    'partings[0].points[1]: the point lies 1.00e+12 from the middle of "made.obj", which measures 1.41; ' +
      'move it within 141, or remove the stroke.',
  );
});
