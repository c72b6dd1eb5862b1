import { describe, expect, test } from 'vitest';
import { IDENTITY } from '../../web/core/affine';
import { LissomError } from '../../web/core/errors';
import { parseRecipe } from '../../web/recipe/parse';
import { example } from './arbitraries';

type Change = readonly [path: string, value: unknown];
const REMOVED = Symbol('removed');

/** The example with fields of it changed: `['steps.0.roi', 5]`. */
function spoilt(...changes: readonly Change[]): unknown {
  const document: unknown = structuredClone(example());
  for (const [path, value] of changes) {
    const keys = path.split('.');
    let held = document as Record<string, unknown>;
    for (const key of keys.slice(0, -1)) held = held[key] as Record<string, unknown>;
    if (value === REMOVED) delete held[keys.at(-1)!];
    else held[keys.at(-1)!] = value;
  }
  return document;
}

/** The line that an error of the changed example shows. */
function problem(...changes: readonly Change[]): string {
  try {
    parseRecipe(spoilt(...changes));
  } catch (error) {
    expect(error).toBeInstanceOf(LissomError);
    expect((error as LissomError).fault).toBe('input');
    return `${(error as LissomError).code}: ${(error as LissomError).message}`;
  }
  return 'the recipe was accepted';
}

test('the example of the description is a recipe, as text and as a value', () => {
  expect(parseRecipe(example())).toEqual(example());
  expect(parseRecipe(`\uFEFF${JSON.stringify(example())}`)).toEqual(example());
});

test('what is left out gets its default', () => {
  const step = { id: 'a', type: 'deform', model: 'm', handles: [] };
  const recipe = parseRecipe({ lissom: 1, models: { m: { builtin: 'bar' } }, steps: [step] });
  expect(recipe.outputs).toEqual([]);
  expect(recipe.steps[0]).toEqual({
    ...step,
    roi: 'all',
    method: 'implicit',
    options: { removeShear: true, scaleDetails: false, iterations: 1, coherenceRing: 1 },
  });
});

const REF = '{ "file": "name.ply" } or { "builtin": "name" }';
const SET = '"all", a list of indices, or { "ranges": [[first, last], ...] }';

describe('an unknown field is refused by name and place', () => {
  test.each<[string, string, unknown?]>([
    ['wobble: unknown field "wobble"', 'wobble'],
    ['steps[0].wobble: unknown field "wobble"; the fields here are id, type, model', 'steps.0.wobble'],
    ['steps[0].options.wobble: unknown field "wobble"', 'steps.0.options.wobble'],
    ['steps[0].handles[1].wobble: unknown field "wobble"', 'steps.0.handles.1.wobble'],
    ['outputs[0].wobble: unknown field "wobble"', 'outputs.0.wobble'],
    [`models.bar: expected ${REF} without the field "wobble"`, 'models.bar.wobble'],
    [`steps[0].roi: expected ${SET} without the field "wobble"`, 'steps.0.roi', { ranges: [], wobble: 1 }],
  ])('%s', (expected, path, value = 1) => {
    expect(problem([path, value])).toContain(`recipe-invalid: ${expected}`);
  });
});

test('a misspelt field is named rather than the one that is missing for it', () => {
  const line = problem(['steps.0.model', REMOVED], ['steps.0.modle', 'bar']);
  expect(line).toContain('steps[0].modle: unknown field "modle"');
});

const late = { ...example().steps[0], id: 'late' };
const bent = example().outputs[0];

describe('what is wrong is said with its place and what to do', () => {
  test.each<[string, string, unknown]>([
    [
      'steps[0].type: unknown step type "explode"; known types are deform, merge, hair, transfer, curves, match, blend, dress.',
      'steps.0.type',
      'explode',
    ],
    [
      'steps[0].handles[1].matrix: expected a matrix of 16 numbers, found a list of 2.',
      'steps.0.handles.1.matrix',
      [1, 2],
    ],
    [
      'steps[0].handles[0].matrix: expected a matrix whose last row is 0 0 0 1',
      'steps.0.handles.0.matrix',
      IDENTITY.map(() => 2),
    ],
    ['steps[0].handles[2].position[1]: expected a number, found "up".', 'steps.0.handles.2.position.1', 'up'],
    ['steps[0].handles[2].vertices: expected exactly one vertex', 'steps.0.handles.2.vertices', [1, 2]],
    [
      'steps[0].roi.ranges[0]: expected a range whose first is not after its last',
      'steps.0.roi',
      { ranges: [[9, 3]] },
    ],
    ['steps[0].roi[1]: expected an index from 0 on, found -3.', 'steps.0.roi', [1, -3]],
    ['steps[0].roi[0]: expected a whole number, found 1.5.', 'steps.0.roi', [1.5]],
    [
      'steps[0].options.iterations: expected a whole number from 1 to 100, found 1000.',
      'steps.0.options.iterations',
      1000,
    ],
    [
      'steps[0].method: expected ("implicit" | "iterative" | "naive" | "isolines"), found "magic".',
      'steps.0.method',
      'magic',
    ],
    ['steps[0].handles: the field "handles" is missing; add it.', 'steps.0.handles', REMOVED],
    ['steps: expected a list, found an object with no fields.', 'steps', {}],
    ['models: expected an object { ... }, found "bar".', 'models', 'bar'],
    ['models._x: expected a name of 1 to 64 letters', 'models._x', { builtin: 'bar' }],
    [`models.bar: expected ${REF}, found an object with no fields.`, 'models.bar', {}],
    ['steps[0].model: there is no model or earlier step "bra"; there are "bar".', 'steps.0.model', 'bra'],
    ['steps[0].model: "bend" is the step itself', 'steps.0.model', 'bend'],
    [
      'steps[0].model: "late" is a later step (steps[1])',
      'steps',
      [{ ...late, id: 'bend', model: 'late' }, late],
    ],
    ['steps[1].id: "late" is the name of an earlier step too', 'steps', [late, late]],
    ['steps[0].id: "bar" is the name of a model too', 'steps.0.id', 'bar'],
    ['outputs[0].step: there is no step "twist"; the steps are "bend".', 'outputs.0.step', 'twist'],
    ['outputs[0].file: cannot write "bent.doc"; end its name in .obj, .ply', 'outputs.0.file', 'bent.doc'],
    ['outputs[0].file: expected a file name without folders', 'outputs.0.file', '../bent.ply'],
    ['outputs[1].file: "bent.ply" is written twice', 'outputs', [bent, bent]],
    ['lissom: expected the version of the recipe', 'lissom', REMOVED],
  ])('%s', (expected, path, value) => {
    expect(problem([path, value])).toContain(`recipe-invalid: ${expected}`);
  });
});

test('several problems are one line with their number', () => {
  expect(problem(['steps.0.roi', 5], ['steps.0.method', 5])).toMatch(/ \(and 1 more\)$/);
});

test('a later version asks for an update and is not called wrong', () => {
  const line = problem(['lissom', 2], ['steps', 'something newer']);
  expect(line).toMatch(/^recipe-too-new: .*version 2.*update/);
});

test('an odd name cannot break the line', () => {
  expect(problem(['steps.0.model', 'a\nb\u2028c'])).not.toMatch(/[\n\u2028]/);
  expect(problem(['steps.0.x\ny', 1])).not.toMatch(/\n/);
});

test.each([
  ['', 'empty'],
  ['{"lissom": 1,\n "models" 2}', 'line 2, column 11'],
  ['{"lissom": 1, "mod', 'ends too early'],
  ['{"lissom": 1, ', 'ends too early'],
  ['null', 'JSON object'],
  ['[1]', 'JSON object'],
  ['ply\nformat ascii 1.0', 'not JSON'],
])('text that is no recipe is refused in one line: %j', (text, reason) => {
  expect(() => parseRecipe(text)).toThrow(expect.objectContaining({ code: 'recipe-invalid' }));
  expect(() => parseRecipe(text)).toThrow(reason);
  expect(() => parseRecipe(text)).not.toThrow('\n');
});
