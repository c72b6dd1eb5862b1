import type { ContoursHost } from '../../../tools/curves/contours/host';
import type { PenHit, PenPart, PenPort } from '../../../view/overlays/types';
import type { Vec3, ViewportPort } from '../../../view/types';
import { type Hand, shiftOf } from './hand';
import type { ContoursState } from './state';

/** The app's side of the contour tool. */
export class AppContoursHost implements ContoursHost {
  #adjusted: 'trim' | 'pull-reach' = 'trim';

  constructor(
    readonly view: ViewportPort,
    readonly pen: PenPort,
    private readonly own: ContoursState,
    private readonly hand: Hand,
  ) {}

  get size(): number {
    return this.hand.size;
  }

  held() {
    const held = this.own.hand.peek();
    const line = this.hand.line();
    return held && line && { picked: held.picked, shift: shiftOf(held), line };
  }

  hover(line: number | null, part: PenPart | null): void {
    const lit = this.own.lit.peek();
    if (lit.line !== line || lit.part !== part) this.own.lit.value = { line, part };
  }

  pickUp(hit: PenHit): void {
    this.hand.pickUp(hit);
    this.hover(null, 'line');
  }

  trim(span: readonly [number, number]): void {
    this.#adjusted = 'trim';
    this.hand.trim(span);
  }

  reach(radius: number): void {
    this.#adjusted = 'pull-reach';
    this.hand.reach(radius);
  }

  settle(): void {
    if (this.own.adjusting.peek()) this.hand.settle(this.#adjusted);
  }

  pull(by: Vec3): void {
    this.hand.pull(by);
  }

  release(): void {
    this.hand.release();
  }

  cancel(): void {
    this.hand.cancel();
  }
}
