import { mkdirSync, readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { writeModel } from '../../web/io/formats';
import { decodeLink } from '../../web/recipe/link/link';
import { parseRecipe } from '../../web/recipe/parse';
import { FakeKernel } from '../run/fake-kernel';
import { sheet } from './shapes';
import { deformRecipe, move, region, Shell } from './shell';

const withFake = () => {
  const kernel = new FakeKernel();
  return { kernel, shell: new Shell({ kernel: async () => kernel }) };
};

const model = sheet(4, 3);
const recipe = deformRecipe([region([0, 1]), region([19], move(0, 0, 1))]);
const linked = { ...recipe, models: { m: { builtin: 'dinosaur' } } };

describe('run', () => {
  test('writes the outputs and the report, and prints nothing when piped', async () => {
    const { shell } = withFake();
    expect(await shell.run(recipe, { 'm.ply': model })).toEqual({ status: 0, stdout: '', stderr: '' });
    expect(shell.files('out')).toEqual(['o.ply']);
    const out = shell.model('out/o.ply');
    expect([...out.faceVertices]).toEqual([...model.faceVertices]);
    expect(out.positions[3 * 19 + 2]).toBe(model.positions[3 * 19 + 2]! + 1);
    const report = JSON.parse(shell.read('report.json'));
    expect(report).toMatchObject({
      lissom: 1,
      models: { m: { vertices: 20, faces: 12, findings: [] } },
      steps: [
        {
          id: 'd',
          type: 'deform',
          vertices: 20,
          faces: 12,
          free: 5,
          degenerate: 2,
          iterations: 1,
          warnings: [],
        },
      ],
    });
    expect(Object.keys(report.steps[0].seconds)).toEqual([
      'assemble',
      'factor',
      'solve',
      'rotate',
      'reconstruct',
    ]);
  });

  test('writes each format by its extension', async () => {
    const { shell } = withFake();
    const files = ['o.ply', 'o.obj', 'o.stl', 'o.glb', 'o.gltf', 'big.OBJ'];
    const outputs = files.map((file) => ({ step: 'd', file }));
    expect((await shell.run({ ...recipe, outputs }, { 'm.ply': model })).status).toBe(0);
    expect(shell.files('out')).toEqual(files.toSorted());
    for (const file of files) expect(shell.model(`out/${file}`).positions.length).toBeGreaterThan(0);
  });

  test('writes every digit of double precision into a PLY', async () => {
    const { shell } = withFake();
    await shell.run(deformRecipe([region([0], move(1 / 3, 0, 0))]), { 'm.ply': model });
    expect(shell.model('out/o.ply').positions[0]).toBe(model.positions[0]! + 1 / 3);
  });

  test('shows one line per step on a terminal', async () => {
    const { shell } = withFake();
    shell.write('m.ply', writeModel(model, 'ply'));
    const { stdout, stderr } = await shell.lissom(
      ['run', shell.write('r.json', recipe), '--out', shell.path('out')],
      true,
    );
    expect(stdout).toBe('');
    expect(stderr.split('\u001b[K').at(-1)).toBe('d  deform  20 vertices  1.50 s\n');
  });

  test('writes into the current folder and the recipe’s models come from beside it', async () => {
    const { shell } = withFake();
    mkdirSync(shell.path('sub'));
    shell.write('sub/m.ply', writeModel(model, 'ply'));
    shell.write('sub/r.json', recipe);
    const cwd = process.cwd();
    expect(
      (await shell.lissom(['run', shell.path('sub/r.json'), '--out', shell.path('deep/er')])).status,
    ).toBe(0);
    expect(process.cwd()).toBe(cwd);
    expect(shell.files('deep/er')).toEqual(['o.ply']);
  });

  test('leaves what is there alone until everything is done, and leaves nothing half written', async () => {
    const { kernel, shell } = withFake();
    await shell.run(recipe, { 'm.ply': model });
    const before = readFileSync(shell.path('out/o.ply'));
    const two = { ...recipe, outputs: [...recipe.outputs, { step: 'd', file: 'p.stl' }] };
    // A folder where the last output should go: the first has been made by then, but nothing is renamed.
    mkdirSync(shell.path('out/p.stl'));
    kernel.restart();
    const moved = { ...two, steps: deformRecipe([region([0], move(5, 5, 5))]).steps };
    const printed = await shell.run(moved, { 'm.ply': model });
    expect(printed).toMatchObject({
      status: 1,
      stderr: expect.stringMatching(/^error: cannot-write: .*\n$/),
    });
    expect(readFileSync(shell.path('out/o.ply'))).toEqual(before);
    expect(shell.files('out')).toEqual(['o.ply', 'p.stl']);
  });

  test('fails with status 1 when the fault is not the user’s', async () => {
    const shell = new Shell({ kernel: () => Promise.reject(new Error('two\nlines')) });
    const printed = await shell.run(recipe, { 'm.ply': model });
    expect(printed).toEqual({ status: 1, stdout: '', stderr: 'error: unexpected: two lines\n' });
  });
});

describe('check', () => {
  const check = (shell: Shell, content: unknown) =>
    shell.lissom(['check', shell.write('r.json', content as object)]);

  test('accepts a recipe whose models are there, without a word', async () => {
    const { shell, kernel } = withFake();
    shell.write('m.ply', writeModel(model, 'ply'));
    expect(await check(shell, recipe)).toEqual({ status: 0, stdout: '', stderr: '' });
    expect(kernel.calls).toEqual([]);
    const { stderr } = await shell.lissom(['check', shell.path('r.json')], true);
    expect(stderr).toMatch(/r\.json is right: 1 step, 1 output\n$/);
  });

  test('finds indices that do not fit the model', async () => {
    const { shell } = withFake();
    shell.write('m.ply', writeModel(model, 'ply'));
    const { status, stderr } = await check(shell, deformRecipe([region([20])]));
    expect([status, stderr]).toEqual([
      2,
      expect.stringMatching(/^error: index-out-of-range: steps\[0\]\.handles\[0\]/),
    ]);
  });

  test('names a model that is missing', async () => {
    const { shell } = withFake();
    const { status, stderr } = await check(shell, recipe);
    expect(status).toBe(2);
    expect(stderr).toMatch(/^error: model-not-found: models\.m \(m\.ply\): There is no file .*m\.ply; .*\n$/);
  });
});

describe('link and unlink', () => {
  test('are each other’s inverse', async () => {
    const { shell } = withFake();
    const link = await shell.lissom(['link', shell.write('r.json', linked)]);
    expect(link).toMatchObject({ status: 0, stderr: '' });
    expect(link.stdout).toMatch(/^http:\/\/localhost:5173\/#r=[\w-]+\n$/);
    const back = await shell.lissom(['unlink', link.stdout]);
    expect(parseRecipe(back.stdout)).toEqual(parseRecipe(linked));
    expect((await shell.lissom(['link', shell.write('again.json', back.stdout)])).stdout).toBe(link.stdout);
  });

  test('lead to the app one names', async () => {
    const { shell } = withFake();
    const { stdout } = await shell.lissom([
      'link',
      shell.write('r.json', linked),
      '--app',
      'https://example.org/x/',
    ]);
    expect(stdout).toMatch(/^https:\/\/example\.org\/x\/#r=/);
    expect(decodeLink(stdout)).toEqual(parseRecipe(linked));
  });

  test('refuse a mesh of one’s own, a cut link and an empty one', async () => {
    const { shell } = withFake();
    const own = await shell.lissom(['link', shell.write('r.json', recipe)]);
    expect([own.status, own.stdout, own.stderr]).toEqual([
      2,
      '',
      expect.stringMatching(/^error: link-needs-file: .*project file/),
    ]);
    const { stdout } = await shell.lissom(['link', shell.write('r.json', linked)]);
    const cut = await shell.lissom(['unlink', stdout.trim().slice(0, -9)]);
    const length = stdout.trim().length;
    expect([cut.status, cut.stdout]).toEqual([2, '']);
    expect(cut.stderr).toContain(`error: link-cut: The link is cut at ${length - 9} of ${length} characters`);
    expect((await shell.lissom(['unlink', 'https://example.org/'])).stderr).toMatch(/^error: link-empty: /);
  });
});

describe('the command itself', () => {
  test('says how it is called, and its version', async () => {
    const { shell } = withFake();
    for (const flag of ['--help', '-h']) {
      const { status, stdout } = await shell.lissom([flag]);
      expect([status, stdout]).toEqual([0, expect.stringContaining('lissom run <recipe.json>')]);
    }
    expect((await shell.lissom(['--version'])).stdout).toMatch(/^\d+\.\d+\.\d+\n$/);
  });

  test.each([
    [[], 'a command is missing'],
    [['dance'], 'there is no command "dance"'],
    [['run'], 'run needs a recipe file'],
    [['unlink'], 'unlink needs a link'],
    [['run', 'a', 'b'], 'run takes one recipe, not also b'],
    [['check', 'a', '--out', 'x'], 'check does not take --out'],
    [['run', 'a', '--wobble'], "Unknown option '--wobble'"],
    [['run', 'a', '--out'], "Option '--out <value>' argument missing"],
  ])('called wrongly it says so with status 1: %j', async (argv, expected) => {
    const { status, stdout, stderr } = await withFake().shell.lissom(argv);
    expect([status, stdout]).toEqual([1, '']);
    expect(stderr).toMatch(/^error: usage: .*\n$/);
    expect(stderr).toContain(expected);
  });

  test('an unreadable place is named', async () => {
    const { shell } = withFake();
    const missing = await shell.lissom(['run', shell.path('nowhere.json')]);
    expect(missing).toMatchObject({
      status: 2,
      stderr: expect.stringMatching(/^error: recipe-not-found: .*nowhere\.json/),
    });
    const folder = await shell.lissom(['run', shell.folder]);
    expect(folder).toMatchObject({ status: 2, stderr: expect.stringMatching(/^error: file-unreadable: /) });
  });
});

const gallery = new URL('../../public/gallery/index.json', import.meta.url);
test('every built-in model of the gallery can be named in a recipe', async () => {
  const { models } = JSON.parse(readFileSync(gallery, 'utf8')) as { models: { name: string }[] };
  const { shell } = withFake();
  for (const { name } of models) {
    const own = { ...deformRecipe([region([0])]), models: { m: { builtin: name } }, outputs: [] };
    expect(await shell.lissom(['check', shell.write('r.json', own)])).toMatchObject({
      status: 0,
      stderr: '',
    });
  }
});

test('a built-in model that does not exist is refused with the names of those that do', async () => {
  const { shell } = withFake();
  const own = { ...deformRecipe([region([0])]), models: { m: { builtin: 'unicorn' } }, outputs: [] };
  const { status, stderr } = await shell.lissom(['check', shell.write('r.json', own)]);
  expect([status, stderr]).toEqual([
    2,
    expect.stringContaining('There is no built-in model "unicorn"; there are '),
  ]);
});
