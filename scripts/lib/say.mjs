/** A heading of the set-up's own output; long work is announced before it begins. */
export const say = (line) => console.log(`\n» ${line}`);

/**
 * Announces work that takes a while, and tells afterwards how long it took.
 *
 * @param line  what is done and about how long that takes
 */
export async function announced(line, work) {
  say(line);
  const started = performance.now();
  const result = await work();
  console.log(`  done in ${((performance.now() - started) / 1000).toFixed(0)} s`);
  return result;
}
