import { zipSync } from 'fflate';
import { LissomError } from '../core/errors';
import { allowance, checkSize } from './budget';
import { checkName, readZip, type ZipLimits } from './zip';

/** A recipe with the meshes it names beside it: what a project file holds. */
export interface Project {
  readonly recipeJson: string;
  /** By the names the recipe uses. */
  readonly files: ReadonlyMap<string, Uint8Array>;
}

const RECIPE = 'recipe.json';
const MOST_FILES = 1000;
/** Zip's earliest date, so that equal projects are equal files. */
const DATE = new Date(1980, 0, 1);
/** What operating systems add to archives they pack. */
const CLUTTER = /^__MACOSX\/|(^|\/)(\.DS_Store|Thumbs\.db|desktop\.ini)$/;

/**
 * The project as a zip archive.
 *
 * @throws LissomError `zip-unsafe-name` for a file name that would not be read back
 */
export function writeProject({ recipeJson, files }: Project): Uint8Array {
  const entries: [string, Uint8Array][] = [[RECIPE, new TextEncoder().encode(recipeJson)]];
  for (const [name, content] of files) {
    checkName(name);
    // The packer keeps names as fields of an object, where that one is none.
    if (name === RECIPE || name.split('/').includes('__proto__'))
      throw new LissomError('zip-unsafe-name', `A model cannot be called “${name}” in a project. Rename it.`);
    entries.push([name, content]);
  }
  return zipSync(Object.fromEntries(entries), { mtime: DATE });
}

/**
 * What `writeProject` packed, also where another program packed it again, with one folder around everything.
 *
 * @throws LissomError `project-without-recipe`, `zip-damaged`, `zip-too-large`, `zip-unsafe-name`, `file-empty`,
 *                     `file-too-large`
 */
export function readProject(bytes: Uint8Array, limits: ZipLimits = limitsOf(bytes.length)): Project {
  const all = [...readZip(bytes, limits)].filter(([name]) => !CLUTTER.test(name));
  const folder = commonFolder(all.map(([name]) => name));
  const files = new Map(all.map(([name, content]) => [name.slice(folder.length), content]));
  const recipe = files.get(RECIPE);
  if (!recipe) {
    const message = `The archive holds no ${RECIPE}, so it is not a project. To open a model in it, unpack it first.`;
    throw new LissomError('project-without-recipe', message);
  }
  files.delete(RECIPE);
  return { recipeJson: new TextDecoder().decode(recipe), files };
}

function limitsOf(size: number): ZipLimits {
  checkSize('project', 'The archive', size);
  const recipe = allowance('recipe', Number.POSITIVE_INFINITY);
  const bytesOf = (name: string) => (name.replace(/^.*\//, '') === RECIPE ? recipe : undefined);
  return { bytes: allowance('project', size), files: MOST_FILES, bytesOf };
}

function commonFolder([first = '', ...others]: readonly string[]): string {
  const folder = first.slice(0, first.indexOf('/') + 1);
  return others.every((name) => name.startsWith(folder)) ? folder : '';
}
