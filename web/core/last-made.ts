/** What was made from something, kept until it is wanted from something else. */
export class LastMade<From extends object, Made> {
  #from: From | undefined;
  #made: Made | undefined;

  async of(from: From, make: () => Promise<Made>): Promise<Made> {
    if (this.#from !== from || this.#made === undefined) {
      this.#made = await make();
      this.#from = from;
    }
    return this.#made;
  }
}
