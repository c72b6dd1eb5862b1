const QUOTE = 34;
const BACKSLASH = 92;
/** What opens a list and an object; two codes further is what closes it. */
const BRACKET = 91;
const BRACE = 123;

/**
 * Whether lists and objects of a JSON text lie in one another deeper than `most`. Reading such a text is no trouble, but
 * whatever walks over it afterwards, an export say, would run out of stack.
 */
export function nestsDeeper(json: Uint8Array, most: number): boolean {
  let depth = 0;
  let inText = false;
  for (let at = 0; at < json.length; at++) {
    const c = json[at]!;
    if (inText) {
      if (c === BACKSLASH) at++;
      else if (c === QUOTE) inText = false;
    } else if (c === QUOTE) inText = true;
    else if (c === BRACKET || c === BRACE) {
      if (++depth > most) return true;
    } else if (c === BRACKET + 2 || c === BRACE + 2) depth--;
  }
  return false;
}
