/** A heading of the set-up's own output; long work is announced before it begins. */
export const say = (line) => console.log(`\n» ${line}`);
