// What the page shows first: a link's recipe, else (there is none, or it is damaged) the work of last time, else the
// first picture.

import { hasLink } from '../recipe/link/link';
import type { BuiltApp } from './app';
import { t } from './i18n';
import { readLink } from './read-link';

/** The recipe of the very first picture: two handles already placed. */
const FIRST = { file: 'recipes/first.json', title: 'dinosaur' };

export async function start(app: BuiltApp, address: string): Promise<void> {
  const link = hasLink(address) ? fragmentOf(address) : undefined;
  if (link !== undefined && ((await restored(app, link)) || (await openLink(app, link)))) return;
  if (await restored(app)) {
    app.messages.toast('info', t('toast.restored'));
    return;
  }
  await app.desk.open({ recipe: await app.gallery.recipe(FIRST.file), title: FIRST.title });
  app.state.hint.value = 'hint.drag';
}

/** @returns whether it could be opened; if not, why is said and everything is as before */
export async function openLink(app: BuiltApp, link: string): Promise<boolean> {
  try {
    const recipe = await readLink(link);
    const title = Object.values(recipe.models).map((ref) => ('builtin' in ref ? ref.builtin : ref.file))[0];
    await app.desk.open({ recipe, title: title ?? '', link });
    return true;
  } catch (error) {
    app.messages.failed(error);
    return false;
  }
}

/** A store that cannot be read must not keep the page from starting. */
async function restored(app: BuiltApp, link?: string): Promise<boolean> {
  try {
    return await app.autosave.restoreLast(link);
  } catch (error) {
    app.messages.failed(error);
    return false;
  }
}

const fragmentOf = (address: string): string => address.slice(address.indexOf('#'));
