import { OrthographicCamera, PerspectiveCamera, Ray, Vector3 } from 'three';
import type { ViewPreset } from './values';

/** Where the camera stands: at `distance` from `target`, `turn` around the vertical, `tilt` down from it. */
interface Stand {
  readonly target: Vector3;
  turn: number;
  tilt: number;
  distance: number;
}

const FIELD_OF_VIEW = 30;
const HALF_TAN = Math.tan((FIELD_OF_VIEW * Math.PI) / 360);
/** Time constant of every motion, in ms: 95 % of the way after three of them. */
const EASE = 50;
const NEAREST = 1e-3;
/** A single vertex is shown from no nearer than this. */
const SMALLEST_FRAME = 0.1;
/** The viewport is this much larger than what it frames. */
const AIR = 1.22;
/** And more above and below: a handle at the top needs room for its gizmo. */
const AIR_ABOVE = 1.36;
const FARTHEST = 60;

const PRESETS: Readonly<Record<ViewPreset, readonly [turn: number, tilt: number]>> = {
  home: [0.6, 1.3],
  front: [0, Math.PI / 2],
  back: [Math.PI, Math.PI / 2],
  left: [-Math.PI / 2, Math.PI / 2],
  right: [Math.PI / 2, Math.PI / 2],
  top: [0, 0],
  bottom: [0, Math.PI],
};

/** A turntable camera. Input moves the goal; what is shown follows at once or softly. Drawn units. */
export class CameraRig {
  readonly #perspective = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 100);
  readonly #flat = new OrthographicCamera(-1, 1, 1, -1, 0.01, 200);
  readonly #goal: Stand = {
    target: new Vector3(),
    turn: PRESETS.home[0],
    tilt: PRESETS.home[1],
    distance: 5,
  };
  readonly #shown: Stand = { ...this.#goal, target: new Vector3() };
  #isFlat = false;
  #width = 1;
  #height = 1;
  /** False where motion is unwanted: everything arrives at once. */
  soft = true;

  constructor() {
    this.#place();
  }

  get camera(): PerspectiveCamera | OrthographicCamera {
    return this.#isFlat ? this.#flat : this.#perspective;
  }

  get orthographic(): boolean {
    return this.#isFlat;
  }

  /** CSS pixels. */
  resize(width: number, height: number): void {
    this.#width = Math.max(1, width);
    this.#height = Math.max(1, height);
    this.#place();
  }

  get size(): { readonly width: number; readonly height: number } {
    return { width: this.#width, height: this.#height };
  }

  orbit(dx: number, dy: number): void {
    const goal = this.#goal;
    goal.turn -= (dx / this.#height) * 2 * Math.PI;
    goal.tilt = Math.min(Math.PI, Math.max(0, goal.tilt - (dy / this.#height) * 2 * Math.PI));
  }

  /** The ground follows the pointer, at the target's depth. */
  pan(dx: number, dy: number): void {
    const unit = (2 * HALF_TAN * this.#goal.distance) / this.#height;
    const { right, up } = axes(this.#goal);
    this.#goal.target.addScaledVector(right, -dx * unit).addScaledVector(up, dy * unit);
  }

  /** Keeps what lies under (x, y), CSS pixels, in its place. `factor` below 1 comes closer. */
  zoom(factor: number, x: number, y: number): void {
    const goal = this.#goal;
    const distance = Math.min(FARTHEST, Math.max(NEAREST, goal.distance * factor));
    const unit = (2 * HALF_TAN * (goal.distance - distance)) / this.#height;
    const { right, up } = axes(goal);
    goal.target
      .addScaledVector(right, (x - this.#width / 2) * unit)
      .addScaledVector(up, (this.#height / 2 - y) * unit);
    goal.distance = distance;
  }

  twist(angle: number): void {
    this.#goal.turn += angle;
  }

  /**
   * Shows points whole from where the goal looks, with a little air.
   *
   * @param points  3 per point, drawn units
   */
  frame(points: ArrayLike<number>): void {
    if (points.length === 0) return;
    const goal = this.#goal;
    const { right, up, back } = axes(goal);
    const tanX = (HALF_TAN * this.#width) / this.#height / AIR;
    const tanY = HALF_TAN / AIR_ABOVE;
    // A point at (x, y, z) in the camera's axes lies inside when |x − cx| ≤ (d − z)·tan: with the widest
    // cone on either side, the two meet in the place and distance sought.
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    let [left, rightmost, bottom, top] = [-Infinity, -Infinity, -Infinity, -Infinity];
    for (let i = 0; i < points.length; i += 3) {
      const [px, py, pz] = [points[i]!, points[i + 1]!, points[i + 2]!];
      const x = right.x * px + right.y * py + right.z * pz;
      const y = up.x * px + up.y * py + up.z * pz;
      const z = back.x * px + back.y * py + back.z * pz;
      const deep = this.#isFlat ? 0 : z;
      left = Math.max(left, deep * tanX - x);
      rightmost = Math.max(rightmost, deep * tanX + x);
      bottom = Math.max(bottom, deep * tanY - y);
      top = Math.max(top, deep * tanY + y);
      for (const [k, value] of [x, y, z].entries()) {
        low[k] = Math.min(low[k]!, value);
        high[k] = Math.max(high[k]!, value);
      }
    }
    const eye = Math.max((left + rightmost) / (2 * tanX), (bottom + top) / (2 * tanY));
    const depth = (low[2]! + high[2]!) / 2;
    const size = Math.max(high[0]! - low[0]!, high[1]! - low[1]!, high[2]! - low[2]!);
    goal.target
      .copy(right)
      .multiplyScalar((rightmost - left) / 2)
      .addScaledVector(up, (top - bottom) / 2)
      .addScaledVector(back, depth);
    const distance = this.#isFlat ? eye : eye - depth;
    goal.distance = Math.min(FARTHEST, Math.max(SMALLEST_FRAME, size, distance));
  }

  look(preset: ViewPreset): void {
    const [turn, tilt] = PRESETS[preset];
    const goal = this.#goal;
    // The short way round.
    const whole = 2 * Math.PI;
    goal.turn = turn + whole * Math.round((this.#shown.turn - turn) / whole);
    goal.tilt = tilt;
  }

  setOrthographic(orthographic: boolean): void {
    this.#isFlat = orthographic;
    this.#place();
  }

  /** Stands at once where told; a camera straight above keeps its turn. */
  standAt(position: Vector3, target: Vector3): void {
    const arm = position.clone().sub(target);
    const distance = Math.min(FARTHEST, Math.max(NEAREST, arm.length() || 1));
    this.#goal.target.copy(target);
    this.#goal.distance = distance;
    this.#goal.tilt = Math.acos(Math.min(1, Math.max(-1, arm.y / distance)));
    if (Math.hypot(arm.x, arm.z) > 1e-9 * distance) this.#goal.turn = Math.atan2(arm.x, arm.z);
    this.jump();
  }

  get target(): Vector3 {
    return this.#shown.target;
  }

  get position(): Vector3 {
    return standing(this.#shown);
  }

  get distance(): number {
    return this.#shown.distance;
  }

  /** Ends every motion. */
  jump(): void {
    this.#shown.target.copy(this.#goal.target);
    this.#shown.turn = this.#goal.turn;
    this.#shown.tilt = this.#goal.tilt;
    this.#shown.distance = this.#goal.distance;
    this.#place();
  }

  /**
   * @param elapsed  ms since the last frame
   * @returns whether there is more way to go
   */
  advance(elapsed: number): boolean {
    const shown = this.#shown;
    const goal = this.#goal;
    const left =
      shown.target.distanceTo(goal.target) / goal.distance +
      Math.abs(shown.turn - goal.turn) +
      Math.abs(shown.tilt - goal.tilt) +
      Math.abs(Math.log(shown.distance / goal.distance));
    if (!this.soft || left < 5e-4) {
      this.jump();
      return false;
    }
    const k = 1 - Math.exp(-elapsed / EASE);
    shown.target.lerp(goal.target, k);
    shown.turn += (goal.turn - shown.turn) * k;
    shown.tilt += (goal.tilt - shown.tilt) * k;
    shown.distance *= (goal.distance / shown.distance) ** k;
    this.#place();
    return true;
  }

  /** From the eye through (x, y), CSS pixels. */
  ray(x: number, y: number, out = new Ray()): Ray {
    const { camera } = this;
    const ndcX = (2 * x) / this.#width - 1;
    const ndcY = 1 - (2 * y) / this.#height;
    if (this.#isFlat) {
      out.origin.set(ndcX, ndcY, -1).unproject(camera);
      out.direction.set(0, 0, -1).transformDirection(camera.matrixWorld);
    } else {
      out.origin.setFromMatrixPosition(camera.matrixWorld);
      out.direction.set(ndcX, ndcY, 0.5).unproject(camera).sub(out.origin).normalize();
    }
    return out;
  }

  /** Drawn units that one CSS pixel spans at a place. */
  pixelSize(place: Vector3): number {
    const depth = this.#isFlat
      ? this.#shown.distance
      : Math.max(NEAREST / 10, -place.clone().applyMatrix4(this.camera.matrixWorldInverse).z);
    return (2 * HALF_TAN * depth) / this.#height;
  }

  #place(): void {
    const { target, distance } = this.#shown;
    const { back, up } = axes(this.#shown);
    const aspect = this.#width / this.#height;
    this.#perspective.aspect = aspect;
    this.#perspective.near = 0.02 * distance;
    this.#perspective.far = distance + 30;
    const half = HALF_TAN * distance;
    this.#flat.left = -half * aspect;
    this.#flat.right = half * aspect;
    this.#flat.top = half;
    this.#flat.bottom = -half;
    const away = this.#isFlat ? 40 : distance;
    const { camera } = this;
    camera.up.copy(up);
    camera.position.copy(target).addScaledVector(back, away);
    camera.lookAt(target);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }
}

function axes({ turn, tilt }: Stand): { right: Vector3; up: Vector3; back: Vector3 } {
  const [st, ct, sp, cp] = [Math.sin(turn), Math.cos(turn), Math.sin(tilt), Math.cos(tilt)];
  return {
    right: new Vector3(ct, 0, -st),
    up: new Vector3(-cp * st, sp, -cp * ct),
    back: new Vector3(sp * st, cp, sp * ct),
  };
}

const standing = (stand: Stand): Vector3 =>
  stand.target.clone().addScaledVector(axes(stand).back, stand.distance);
