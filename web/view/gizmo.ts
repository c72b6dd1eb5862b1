import { type Camera, Matrix4, Mesh, Object3D, type Scene } from 'three';
import { TransformControls } from 'three/addons/controls/TransformControls.js';
import type { Palette } from './palette';
import type { GizmoEvents, GizmoState } from './values';
import type { ViewSpace } from './view-space';

/** Scales below this would fold the handle onto itself. */
const SMALLEST = 0.01;

/** The move/turn/scale handle. Fed with pointers by the viewport, so that nothing else takes them. */
export class Gizmo {
  readonly #controls: TransformControls;
  readonly #helper: Object3D;
  readonly #anchor = new Object3D();
  #events: GizmoEvents | undefined;
  #space: ViewSpace;
  #start: readonly number[] = [];

  constructor(scene: Scene, camera: Camera, space: ViewSpace, changed: () => void) {
    this.#space = space;
    this.#controls = new TransformControls(camera);
    this.#controls.setSpace('local');
    this.#controls.setSize(1.05);
    this.#controls.showXYZE = false;
    this.#helper = this.#controls.getHelper();
    simplify(this.#helper);
    scene.add(this.#anchor, this.#helper);
    this.#controls.addEventListener('change', changed);
    this.#controls.addEventListener('objectChange', () => this.#moved());
  }

  /** Over a part of the gizmo, or dragging one. */
  get busy(): boolean {
    return this.#controls.axis !== null || this.#controls.dragging;
  }

  get dragging(): boolean {
    return this.#controls.dragging;
  }

  setCamera(camera: Camera): void {
    this.#controls.camera = camera;
  }

  setPalette(palette: Palette): void {
    this.#controls.setColors(...palette.axes, palette.warn);
  }

  set(state: GizmoState | null, events: GizmoEvents | undefined, space: ViewSpace): void {
    // What is held when the gizmo goes has not happened; its holder has to know.
    if (!state) this.cancel();
    this.#events = events;
    this.#space = space;
    if (!state) {
      this.#controls.detach();
      return;
    }
    if (this.#controls.mode !== state.mode && !this.#controls.dragging) this.#controls.setMode(state.mode);
    this.#controls.showX = !state.single;
    this.#controls.showY = !state.single;
    // While it is dragged, the gizmo is where the hand is.
    if (!this.#controls.dragging) this.#stand(state.matrix);
    if (this.#controls.object !== this.#anchor) this.#controls.attach(this.#anchor);
    this.#helper.updateMatrixWorld(true);
  }

  /** Device coordinates, −1 to 1. */
  hover(x: number, y: number): void {
    this.#controls.pointerHover(pointer(x, y, -1));
  }

  leave(): void {
    if (!this.#controls.dragging) this.#controls.axis = null;
  }

  /** @returns whether the gizmo takes the gesture */
  down(x: number, y: number): boolean {
    if (!this.#controls.object) return false;
    this.#helper.updateMatrixWorld(true);
    this.hover(x, y);
    if (this.#controls.axis === null) return false;
    this.#start = this.#matrix();
    this.#controls.pointerDown(pointer(x, y, 0));
    if (this.#controls.dragging) this.#events?.onStart();
    return this.#controls.dragging;
  }

  move(x: number, y: number): void {
    this.#controls.pointerMove(pointer(x, y, -1));
  }

  up(): void {
    if (!this.#controls.dragging) return;
    this.#controls.pointerUp(pointer(0, 0, 0));
    this.#events?.onEnd();
  }

  /** Back to where the drag began. */
  cancel(): void {
    if (!this.#controls.dragging) return;
    this.#controls.pointerUp(null);
    this.#stand(this.#start);
    if (this.#events?.onCancel) this.#events.onCancel();
    else {
      this.#events?.onChange(this.#start);
      this.#events?.onEnd();
    }
  }

  set visible(visible: boolean) {
    this.#helper.visible = visible && this.#controls.object !== undefined;
  }

  dispose(): void {
    this.#controls.detach();
    this.#controls.getHelper().dispose();
    this.#helper.removeFromParent();
    this.#anchor.removeFromParent();
  }

  #moved(): void {
    const { scale } = this.#anchor;
    scale.set(Math.max(SMALLEST, scale.x), Math.max(SMALLEST, scale.y), Math.max(SMALLEST, scale.z));
    this.#events?.onChange(this.#matrix());
  }

  #stand(matrix: readonly number[]): void {
    const { position, quaternion, scale } = this.#anchor;
    this.#space.frameToView(new Matrix4().fromArray([...matrix]), position, quaternion, scale);
    this.#anchor.updateMatrixWorld();
  }

  #matrix(): number[] {
    const { position, quaternion, scale } = this.#anchor;
    return this.#space.frameToModel(position, quaternion, scale, new Matrix4()).toArray();
  }
}

/** One arrow per axis is enough: takes away the parts that lie on the negative side. */
function simplify(helper: Object3D): void {
  const spare: Mesh[] = [];
  helper.traverse((part) => {
    const axis = ['X', 'Y', 'Z'].indexOf(part.name);
    if (axis < 0 || !(part instanceof Mesh)) return;
    part.geometry.computeBoundingBox();
    if (part.geometry.boundingBox.max.getComponent(axis) < 0.01 && !isRing(part)) spare.push(part);
  });
  for (const part of spare) {
    part.removeFromParent();
    part.geometry.dispose();
  }
}

const isRing = (part: Mesh): boolean => part.geometry.type === 'TorusGeometry';

const pointer = (x: number, y: number, button: number): PointerEvent =>
  ({ x, y, button }) as unknown as PointerEvent;
