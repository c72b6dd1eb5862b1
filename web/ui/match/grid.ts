/** How many cells side by side, and one below the other. */
export interface Cell {
  readonly columns: number;
  readonly rows: number;
}

/** Room for so many models, each as near to square as may be; up to three in one row. */
export function gridOf(count: number): Cell {
  const columns = count <= 3 ? count : Math.ceil(Math.sqrt(count));
  return { columns, rows: Math.ceil(count / columns) };
}

/** Where a cell is, for its style. */
export function placeOf({ columns, rows }: Cell, at: number) {
  const share = (part: number, whole: number) => `${(100 * part) / whole}%`;
  return {
    left: share(at % columns, columns),
    top: share(Math.floor(at / columns), rows),
    width: share(1, columns),
    height: share(1, rows),
  };
}
