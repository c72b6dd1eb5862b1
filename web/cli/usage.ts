import { parseArgs } from 'node:util';
import { LissomError } from '../core/errors';

/** Where `npm start` serves the app: what a link leads to unless told otherwise. */
const APP = 'http://localhost:5173/';

export const USAGE = `Reshape 3D models by recipe. Units: model units and degrees; indices start at 0.

Usage
  lissom run <recipe.json> [--out <folder>] [--report <report.json>]
      Runs the recipe and writes its outputs into the folder (here by default), in the format of each
      file's extension; PLY in double precision. Models are looked for beside the recipe.
  lissom check <recipe.json>
      Checks the recipe, that its models can be read and that its indices fit them.
  lissom link <recipe.json> [--app <address>]
      Prints the link that opens the recipe in the app at an address (${APP}).
  lissom unlink <link>
      Prints the recipe in a link.
  lissom --help, lissom --version

Exit status
  0  done
  2  the recipe, the link or a model is wrong: one line on stderr says what, where and what to do
  1  anything else
On an error nothing is written.
`;

export type Command =
  | { readonly name: 'help' | 'version' }
  | {
      readonly name: 'run';
      readonly recipe: string;
      readonly out: string;
      readonly report: string | undefined;
    }
  | { readonly name: 'check'; readonly recipe: string }
  | { readonly name: 'link'; readonly recipe: string; readonly app: string }
  | { readonly name: 'unlink'; readonly link: string };

/** The options each command takes beside --help. */
const OPTIONS: Readonly<Record<string, readonly string[]>> = {
  run: ['out', 'report'],
  check: [],
  link: ['app'],
  unlink: [],
};

/** @throws LissomError `usage` */
export function commandOf(argv: readonly string[]): Command {
  const { values, positionals } = parsed(argv);
  if (values.help) return { name: 'help' };
  if (values.version) return { name: 'version' };
  const [name = '', subject, ...rest] = positionals;
  const allowed = OPTIONS[name];
  if (!allowed) throw usage(name ? `there is no command ${JSON.stringify(name)}` : 'a command is missing');
  const foreign = Object.keys(values).find((option) => !allowed.includes(option));
  if (foreign) throw usage(`${name} does not take --${foreign}`);
  if (subject === undefined) throw usage(`${name} needs ${name === 'unlink' ? 'a link' : 'a recipe file'}`);
  if (rest.length > 0)
    throw usage(`${name} takes one ${name === 'unlink' ? 'link' : 'recipe'}, not also ${rest[0]}`);
  if (name === 'run') return { name, recipe: subject, out: values.out ?? '.', report: values.report };
  if (name === 'link') return { name, recipe: subject, app: values.app ?? APP };
  return name === 'check' ? { name, recipe: subject } : { name: 'unlink', link: subject };
}

function parsed(argv: readonly string[]) {
  try {
    return parseArgs({
      args: [...argv],
      allowPositionals: true,
      options: {
        help: { type: 'boolean', short: 'h' },
        version: { type: 'boolean' },
        out: { type: 'string' },
        report: { type: 'string' },
        app: { type: 'string' },
      },
    });
  } catch (error) {
    throw usage((error as Error).message.split('. ')[0]!);
  }
}

const usage = (what: string): LissomError =>
  new LissomError('usage', `${what}; lissom --help says how it is called.`, 'crash');
