/** Vertices by distance, the nearest first: a binary heap. */
export class NearestFirst {
  readonly #held: (readonly [vertex: number, distance: number])[] = [];

  push(vertex: number, distance: number): void {
    const held = this.#held;
    const entry = [vertex, distance] as const;
    let at = held.push(entry) - 1;
    for (let up = (at - 1) >> 1; at > 0 && held[up]![1] > distance; up = (at - 1) >> 1) {
      held[at] = held[up]!;
      at = up;
    }
    held[at] = entry;
  }

  pop(): readonly [vertex: number, distance: number] | undefined {
    const held = this.#held;
    const first = held[0];
    const last = held.pop();
    if (!first || !last || held.length === 0) return first;
    let at = 0;
    for (let down = 1; down < held.length; down = 2 * at + 1) {
      if (down + 1 < held.length && held[down + 1]![1] < held[down]![1]) down++;
      if (held[down]![1] >= last[1]) break;
      held[at] = held[down]!;
      at = down;
    }
    held[at] = last;
    return first;
  }
}
