/** Where a command writes; in tests, into strings. */
export interface Stream {
  write(text: string): unknown;
  readonly isTTY?: boolean;
}

export interface Streams {
  /** Results only. */
  readonly stdout: Stream;
  /** Progress on a terminal, and the one line of an error. */
  readonly stderr: Stream;
}
