// Every pointer that touches the canvas, in one place: who gets the gesture is decided when it begins.

import type { CameraRig } from './camera-rig';
import type { Gizmo } from './gizmo';
import type { Hit, PointerHandler, PointerSample } from './values';

export interface PointerHost {
  readonly rig: CameraRig;
  readonly gizmo: Gizmo;
  pick(x: number, y: number): Hit | null;
  /** Something may look different now. */
  changed(): void;
}

type Gesture = 'none' | 'tool' | 'gizmo' | 'orbit' | 'pan' | 'pinch';

interface Place {
  x: number;
  y: number;
}

const RIGHT = 2;
const MIDDLE = 1;

export class PointerInput {
  handler: PointerHandler | null = null;
  #gesture: Gesture = 'none';
  /** The pointer that began a gesture of one pointer. */
  #owner = -1;
  #last: Place = { x: 0, y: 0 };
  readonly #fingers = new Map<number, Place>();
  #penSeen = false;
  #inside = false;
  readonly #stop = new AbortController();

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly host: PointerHost,
  ) {
    const { signal } = this.#stop;
    canvas.style.touchAction = 'none';
    canvas.addEventListener('pointerdown', (event) => this.#down(event), { signal });
    canvas.addEventListener('pointermove', (event) => this.#move(event), { signal });
    canvas.addEventListener('pointerup', (event) => this.#up(event), { signal });
    canvas.addEventListener('pointercancel', (event) => this.#lost(event), { signal });
    canvas.addEventListener('lostpointercapture', (event) => this.#lost(event), { signal });
    canvas.addEventListener('pointerleave', () => this.#leave(), { signal });
    canvas.addEventListener('wheel', (event) => this.#wheel(event), { signal, passive: false });
    canvas.addEventListener('contextmenu', (event) => event.preventDefault(), { signal });
    // A middle press must not start the browser's own scrolling.
    canvas.addEventListener('mousedown', (event) => event.button === MIDDLE && event.preventDefault(), {
      signal,
    });
    window.addEventListener('keydown', (event) => this.#key(event), { signal, capture: true });
    window.addEventListener('blur', () => this.cancel(), { signal });
  }

  /** Ends what is under way as if it had never begun; a camera's journey stays where it is. */
  cancel(): void {
    const gesture = this.#gesture;
    this.#gesture = 'none';
    if (gesture === 'tool') this.handler?.cancel();
    if (gesture === 'gizmo') this.host.gizmo.cancel();
    this.host.changed();
  }

  dispose(): void {
    this.cancel();
    this.#stop.abort();
  }

  #down(event: PointerEvent): void {
    const at = this.#place(event);
    if (event.pointerType === 'pen') this.#penSeen = true;
    if (event.pointerType === 'touch') {
      const drawing = this.#gesture === 'tool' || this.#gesture === 'gizmo';
      // A palm on the glass while the pen draws.
      if (drawing && !this.#fingers.has(this.#owner)) return;
      this.#fingers.set(event.pointerId, at);
      if (this.#fingers.size === 2) {
        this.cancel();
        this.#gesture = 'pinch';
        this.#capture(event);
        return;
      }
      if (this.#fingers.size > 2) return;
    } else if (this.#gesture !== 'none') {
      return;
    }
    this.#owner = event.pointerId;
    this.#last = at;
    this.#gesture = this.#begin(event, at);
    this.#capture(event);
    this.host.changed();
  }

  #begin(event: PointerEvent, at: Place): Gesture {
    if (event.button === MIDDLE) return 'pan';
    if (event.button === RIGHT) return event.shiftKey ? 'pan' : 'orbit';
    // Once a pen has been seen, fingers only move the camera: a palm lies on the glass.
    if (event.pointerType === 'touch' && this.#penSeen) return 'orbit';
    if (this.host.gizmo.down(...this.#device(at))) return 'gizmo';
    if (this.handler?.down(this.#sample(event))) return 'tool';
    return 'orbit';
  }

  #move(event: PointerEvent): void {
    const at = this.#place(event);
    this.#inside = true;
    const finger = this.#fingers.get(event.pointerId);
    if (this.#gesture === 'pinch') {
      if (finger) this.#pinch(event.pointerId, at);
      return;
    }
    if (finger) Object.assign(finger, at);
    if (this.#gesture === 'none') {
      this.#hover(event, at);
      return;
    }
    if (event.pointerId !== this.#owner) return;
    const [dx, dy] = [at.x - this.#last.x, at.y - this.#last.y];
    this.#last = at;
    switch (this.#gesture) {
      case 'tool': {
        const samples = event.getCoalescedEvents?.() ?? [];
        this.handler?.move((samples.length > 0 ? samples : [event]).map((sample) => this.#sample(sample)));
        break;
      }
      case 'gizmo':
        this.host.gizmo.move(...this.#device(at));
        break;
      case 'orbit':
        this.host.rig.orbit(dx, dy);
        break;
      case 'pan':
        this.host.rig.pan(dx, dy);
        break;
    }
    this.host.changed();
  }

  #hover(event: PointerEvent, at: Place): void {
    if (event.pointerType === 'touch') return;
    if (event.pointerType === 'pen') this.#penSeen = true;
    const wasBusy = this.host.gizmo.busy;
    this.host.gizmo.hover(...this.#device(at));
    if (!this.host.gizmo.busy) this.handler?.hover(this.#sample(event));
    else if (!wasBusy) this.handler?.leave();
  }

  #up(event: PointerEvent): void {
    this.#fingers.delete(event.pointerId);
    if (this.#gesture === 'pinch') {
      // The finger that stays does nothing more until it is lifted too.
      if (this.#fingers.size === 0) this.#gesture = 'none';
      return;
    }
    if (event.pointerId !== this.#owner) return;
    const gesture = this.#gesture;
    this.#gesture = 'none';
    if (gesture === 'tool') this.handler?.up(this.#sample(event));
    if (gesture === 'gizmo') {
      this.host.gizmo.up();
      if (event.pointerType !== 'touch') this.host.gizmo.hover(...this.#device(this.#place(event)));
    }
    this.host.changed();
  }

  #lost(event: PointerEvent): void {
    this.#fingers.delete(event.pointerId);
    if (this.#gesture === 'pinch') {
      if (this.#fingers.size === 0) this.#gesture = 'none';
    } else if (event.pointerId === this.#owner && this.#gesture !== 'none') this.cancel();
  }

  #leave(): void {
    if (!this.#inside || this.#gesture !== 'none') return;
    this.#inside = false;
    this.host.gizmo.leave();
    this.handler?.leave();
  }

  #pinch(id: number, at: Place): void {
    const [first, second] = [...this.#fingers.keys()];
    if (second === undefined || (id !== first && id !== second)) return;
    const moving = this.#fingers.get(id)!;
    const still = this.#fingers.get(id === first ? second : first!)!;
    const before = { x: moving.x - still.x, y: moving.y - still.y };
    const after = { x: at.x - still.x, y: at.y - still.y };
    const [was, is] = [Math.hypot(before.x, before.y), Math.hypot(after.x, after.y)];
    const { rig } = this.host;
    rig.pan((at.x - moving.x) / 2, (at.y - moving.y) / 2);
    if (was > 1 && is > 1) {
      rig.zoom(was / is, (at.x + still.x) / 2, (at.y + still.y) / 2);
      rig.twist(Math.asin((before.x * after.y - before.y * after.x) / (was * is)));
    }
    Object.assign(moving, at);
    this.host.changed();
  }

  #wheel(event: WheelEvent): void {
    event.preventDefault();
    const unit = event.deltaMode === 1 ? 16 : event.deltaMode === 2 ? this.host.rig.size.height : 1;
    const { x, y } = this.#place(event);
    const [dx, dy] = [event.deltaX * unit, event.deltaY * unit];
    // Browsers report a trackpad's pinch as ctrl + wheel, in finer steps.
    const rate = event.ctrlKey ? 0.01 : 0.0016;
    const turn = Math.min(240, Math.max(-240, dy || dx));
    this.host.rig.zoom(Math.exp(turn * rate), x, y);
    this.host.changed();
  }

  #key(event: KeyboardEvent): void {
    if (event.key !== 'Escape' || (this.#gesture !== 'tool' && this.#gesture !== 'gizmo')) return;
    event.stopPropagation();
    event.preventDefault();
    this.cancel();
  }

  #capture(event: PointerEvent): void {
    try {
      this.canvas.setPointerCapture(event.pointerId);
    } catch {
      // A pointer that is already gone, or one made by a script, cannot be captured: it works without.
    }
  }

  #place(event: MouseEvent): Place {
    const box = this.canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  /** CSS pixels to −1…1, y up. */
  #device({ x, y }: Place): [number, number] {
    const { width, height } = this.host.rig.size;
    return [(2 * x) / width - 1, 1 - (2 * y) / height];
  }

  #sample(event: PointerEvent): PointerSample {
    const { x, y } = this.#place(event);
    const kind = event.pointerType;
    return {
      x,
      y,
      pressure: kind === 'mouse' ? 0.5 : event.pressure,
      pointerType: kind === 'pen' || kind === 'touch' ? kind : 'mouse',
      button: event.button,
      shift: event.shiftKey,
      alt: event.altKey,
      ctrl: event.ctrlKey || event.metaKey,
      hit: this.host.pick(x, y),
    };
  }
}
