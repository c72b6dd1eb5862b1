import { parseArgs } from 'node:util';
import { LissomError } from '../core/errors';

/** Where `npm start` serves the app: what a link leads to unless told otherwise. */
const APP = 'http://localhost:5173/';

/** In seconds: what a timer of Node can count to. */
const LONGEST_TIMEOUT = 2_000_000;

export const USAGE = `Reshape 3D models by recipe. Units: model units and degrees; indices start at 0.

Usage
  lissom run <recipe.json> [--out <folder>] [--report <report.json>] [--timeout <seconds>] [--allow-outside]
      Runs the recipe and writes its outputs into the folder (here by default), in the format of each
      file's extension; PLY in double precision. Models are looked for beside the recipe; elsewhere only
      with --allow-outside. Ctrl-C or the timeout end a run, and nothing is written.
  lissom check <recipe.json> [--allow-outside]
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
      /** In seconds. */
      readonly timeout: number | undefined;
      readonly allowOutside: boolean;
    }
  | { readonly name: 'check'; readonly recipe: string; readonly allowOutside: boolean }
  | { readonly name: 'link'; readonly recipe: string; readonly app: string }
  | { readonly name: 'unlink'; readonly link: string };

/** The options each command takes beside --help. */
const OPTIONS: Readonly<Record<string, readonly string[]>> = {
  run: ['out', 'report', 'timeout', 'allow-outside'],
  check: ['allow-outside'],
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
  if (name === 'link') return { name, recipe: subject, app: values.app ?? APP };
  if (name === 'unlink') return { name, link: subject };
  const allowOutside = values['allow-outside'] ?? false;
  if (name === 'check') return { name, recipe: subject, allowOutside };
  const { out = '.', report, timeout } = values;
  return { name: 'run', recipe: subject, out, report, timeout: secondsOf(timeout), allowOutside };
}

function secondsOf(text: string | undefined): number | undefined {
  if (text === undefined) return undefined;
  const seconds = Number(text);
  // The clock that is asked for a longer time rings at once.
  if (!(seconds > 0 && seconds <= LONGEST_TIMEOUT))
    throw usage(`--timeout takes seconds above 0, at most ${LONGEST_TIMEOUT}, not ${JSON.stringify(text)}`);
  return seconds;
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
        timeout: { type: 'string' },
        'allow-outside': { type: 'boolean' },
        app: { type: 'string' },
      },
    });
  } catch (error) {
    throw usage((error as Error).message.split('. ')[0]!);
  }
}

const usage = (what: string): LissomError =>
  new LissomError('usage', `${what}; lissom --help says how it is called.`, 'crash');
