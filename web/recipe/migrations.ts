import { LissomError } from '../core/errors';
import { RECIPE_VERSION } from './recipe';

/** `migrations[k]` turns a document of version k + 1 into one of version k + 2; it may trust nothing. */
const migrations: readonly ((document: Record<string, unknown>) => Record<string, unknown>)[] = [];

/**
 * A document of any version as one of this version, not yet validated.
 *
 * @throws LissomError `recipe-too-new`, `recipe-invalid` where it does not say its version
 */
export function migrate(document: Record<string, unknown>): Record<string, unknown> {
  const version = document.lissom;
  if (typeof version !== 'number' || !Number.isInteger(version) || version < 1)
    throw new LissomError(
      'recipe-invalid',
      `lissom: expected the version of the recipe, "lissom": ${RECIPE_VERSION}; this may not be a Lissom recipe.`,
    );
  if (version > RECIPE_VERSION)
    throw new LissomError(
      'recipe-too-new',
      `lissom: this recipe is of version ${version}, this Lissom knows up to ${RECIPE_VERSION}; update Lissom to open it.`,
    );
  return migrations.slice(version - 1).reduce((held, step) => step(held), document);
}
