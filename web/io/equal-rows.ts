/**
 * For each of `count` rows the first row that equals it exactly, in every one of `tables` (3 numbers a row, the
 * first at `starts[k]`). A row with a NaN equals only itself.
 */
export function firstEqualRow(
  tables: readonly Float64Array[],
  starts: readonly number[],
  count: number,
): Uint32Array {
  const slots = new Int32Array(2 ** Math.ceil(Math.log2(2 * count + 2))).fill(-1);
  const first = new Uint32Array(count);
  const number = new Float64Array(1);
  const bits = new Uint32Array(number.buffer);
  const equal = (a: number, b: number): boolean =>
    tables.every((table, k) => {
      const [i, j] = [starts[k]! + 3 * a, starts[k]! + 3 * b];
      return table[i] === table[j] && table[i + 1] === table[j + 1] && table[i + 2] === table[j + 2];
    });
  for (let row = 0; row < count; row++) {
    let hash = 0;
    tables.forEach((table, k) => {
      for (let c = 0; c < 3; c++) {
        // Adding zero makes −0 and 0, which are equal, one.
        number[0] = table[starts[k]! + 3 * row + c]! + 0;
        hash = Math.imul(hash ^ bits[0]!, 0x9e3779b1);
        hash = Math.imul(hash ^ (hash >>> 15) ^ bits[1]!, 0x85ebca6b);
      }
    });
    let slot = (hash ^ (hash >>> 13)) & (slots.length - 1);
    while (slots[slot]! >= 0 && !equal(slots[slot]!, row)) slot = (slot + 1) & (slots.length - 1);
    if (slots[slot]! < 0) slots[slot] = row;
    first[row] = slots[slot]!;
  }
  return first;
}
