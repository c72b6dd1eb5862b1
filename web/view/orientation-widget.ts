import { type Camera, Vector3 } from 'three';
import type { Palette } from './palette';
import type { Vec3, ViewPreset } from './values';
import type { ViewSpace } from './view-space';

const SIZE = 92;
const ARM = 32;
const BEAD = 9.5;
/** Presses this near count. */
const REACH = 14;
const SVG = 'http://www.w3.org/2000/svg';

export type ViewLabels = Readonly<Record<Exclude<ViewPreset, 'home'>, string>>;

const ENGLISH: ViewLabels = {
  front: 'View from the front',
  back: 'View from behind',
  left: 'View from the left',
  right: 'View from the right',
  top: 'View from above',
  bottom: 'View from below',
};

interface Arm {
  readonly group: SVGGElement;
  readonly line: SVGLineElement | undefined;
  /** All that stands at the arm's end. */
  readonly ends: readonly SVGElement[];
  readonly bead: SVGCircleElement;
  readonly text: SVGTextElement;
  /** Model space. */
  readonly axis: Vec3;
  readonly index: number;
  readonly positive: boolean;
  readonly place: Vector3;
}

/** The model's axes as they lie on the screen; pressing one looks along it. Plain SVG: crisp and focusable. */
export class OrientationWidget {
  readonly element = document.createElementNS(SVG, 'svg');
  readonly #lines = document.createElementNS(SVG, 'g');
  readonly #beads = document.createElementNS(SVG, 'g');
  readonly #arms: Arm[] = [];
  #palette: Palette | undefined;
  #zUp = false;

  constructor(
    private readonly look: (preset: ViewPreset) => void,
    private readonly labels: ViewLabels = ENGLISH,
  ) {
    this.element.setAttribute('viewBox', `${-SIZE / 2} ${-SIZE / 2} ${SIZE} ${SIZE}`);
    this.element.setAttribute('role', 'group');
    Object.assign(this.element.style, {
      position: 'absolute',
      right: '10px',
      bottom: '10px',
      width: `${SIZE}px`,
      height: `${SIZE}px`,
      overflow: 'visible',
      userSelect: 'none',
      touchAction: 'manipulation',
    });
    this.element.append(this.#lines, this.#beads);
    for (const positive of [false, true]) {
      for (let index = 0; index < 3; index++) this.#arms.push(this.#arm(index, positive));
    }
  }

  setPalette(palette: Palette): void {
    this.#palette = palette;
    for (const { line, bead, text, index, positive } of this.#arms) {
      const colour = palette.axes[index]!;
      line?.setAttribute('stroke', colour);
      bead.setAttribute('fill', positive ? colour : palette.panel);
      bead.setAttribute('stroke', colour);
      text.setAttribute('fill', positive ? '#ffffff' : 'transparent');
    }
  }

  update(camera: Camera, space: ViewSpace): void {
    if (!this.#palette) return;
    if (this.#zUp !== space.zUp) {
      this.#zUp = space.zUp;
      for (const arm of this.#arms) arm.group.setAttribute('aria-label', this.labels[this.#preset(arm)]);
    }
    for (const arm of this.#arms) {
      space.directionToView(arm.axis, arm.place).transformDirection(camera.matrixWorldInverse);
      const { x, y, z } = arm.place;
      for (const end of arm.ends) {
        end.setAttribute('transform', `translate(${(ARM * x).toFixed(2)} ${(-ARM * y).toFixed(2)})`);
      }
      arm.line?.setAttribute('x2', ((ARM - BEAD + 1) * x).toFixed(2));
      arm.line?.setAttribute('y2', (-(ARM - BEAD + 1) * y).toFixed(2));
      for (const part of [arm.group, arm.line]) part?.setAttribute('opacity', (0.78 + 0.22 * z).toFixed(2));
    }
    const order = [...this.#arms].sort((a, b) => a.place.z - b.place.z);
    const drawn = [...this.#beads.children];
    // A group that is moved in the document loses its focus and its press: only when the order is new.
    if (order.some((arm, i) => drawn[i] !== arm.group)) {
      if (!this.element.contains(document.activeElement))
        this.#beads.append(...order.map((arm) => arm.group));
    }
  }

  dispose(): void {
    this.element.remove();
  }

  #preset({ index, positive }: Pick<Arm, 'index' | 'positive'>): Exclude<ViewPreset, 'home'> {
    if (index === 0) return positive ? 'right' : 'left';
    const upright = this.#zUp ? index === 2 : index === 1;
    if (upright) return positive ? 'top' : 'bottom';
    // A z-up model's front is at its −y.
    return positive !== this.#zUp ? 'front' : 'back';
  }

  #arm(index: number, positive: boolean): Arm {
    const group = document.createElementNS(SVG, 'g');
    const line = positive ? document.createElementNS(SVG, 'line') : undefined;
    const bead = document.createElementNS(SVG, 'circle');
    const text = document.createElementNS(SVG, 'text');
    line?.setAttribute('stroke-width', '2');
    line?.setAttribute('stroke-linecap', 'round');
    bead.setAttribute('r', String(positive ? BEAD : BEAD - 2.5));
    bead.setAttribute('stroke-width', '1.5');
    text.textContent = 'XYZ'[index]!;
    text.setAttribute('text-anchor', 'middle');
    text.setAttribute('dominant-baseline', 'central');
    text.setAttribute('font-size', '11');
    text.setAttribute('font-weight', '600');
    text.setAttribute('font-family', 'system-ui, sans-serif');
    // Lines lie beneath and do not take part: a bead's own middle is where it is pressed.
    if (line) this.#lines.append(line);
    const reach = document.createElementNS(SVG, 'circle');
    reach.setAttribute('r', String(REACH));
    reach.setAttribute('fill', 'transparent');
    group.append(reach, bead, text);
    group.setAttribute('role', 'button');
    group.setAttribute('tabindex', '0');
    group.setAttribute('aria-label', this.labels[this.#preset({ index, positive })]);
    group.style.cursor = 'pointer';
    const press = (): void => this.look(this.#preset({ index, positive }));
    group.addEventListener('click', press);
    // A mouse press leaves the focus, and with it the keyboard, where it was.
    group.addEventListener('mousedown', (event) => event.preventDefault());
    group.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter' && event.key !== ' ') return;
      event.preventDefault();
      press();
    });
    this.#beads.append(group);
    const axis: [number, number, number] = [0, 0, 0];
    axis[index] = positive ? 1 : -1;
    return {
      group,
      line,
      ends: [reach, bead, text],
      bead,
      text,
      axis,
      index,
      positive,
      place: new Vector3(),
    };
  }
}
