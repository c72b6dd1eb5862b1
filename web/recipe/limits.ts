// What a recipe may hold, however it comes in. Wide enough for every unit that models come in, narrow enough that squares
// and cubes of its numbers stay finite and that a list cannot keep a machine busy for a day.

/** Greatest size of a recipe's text, in bytes; the largest of the gallery has a hundredth of it. */
export const MAX_RECIPE_BYTES = 32_000_000;
/** Greatest size of a coordinate, a length or an entry of a matrix, in model units. */
export const MAX_COORDINATE = 1e30;
/** Most handles of a step; they share no vertex. */
export const MAX_HANDLES = 1000;
/** Most steps and most outputs. */
export const MAX_STEPS = 1000;
