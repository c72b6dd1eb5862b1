import { type Matrix4, Quaternion, Vector3 } from 'three';
import type { Vec3, ViewModel } from './values';

const UPRIGHT = new Quaternion().setFromAxisAngle(new Vector3(1, 0, 0), -Math.PI / 2);

/**
 * Between the model's own coordinates (double precision, any offset and size, y or z up) and those that
 * are drawn: centred, upright, the bounding box's half diagonal = 1, so single precision is enough.
 */
export class ViewSpace {
  private constructor(
    readonly centre: Vec3,
    /** Drawn units per model unit. */
    readonly scale: number,
    readonly zUp: boolean,
  ) {}

  static readonly identity = new ViewSpace([0, 0, 0], 1, false);

  /** Framed by the finite vertices; a model without extent keeps its unit. */
  static around(model: Pick<ViewModel, 'positions' | 'upAxis'>): ViewSpace {
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    const { positions } = model;
    for (let i = 0; i < positions.length; i++) {
      const x = positions[i]!;
      if (!Number.isFinite(x)) continue;
      const k = i % 3;
      if (x < low[k]!) low[k] = x;
      if (x > high[k]!) high[k] = x;
    }
    if (low.some((x) => x === Infinity)) return ViewSpace.identity;
    const centre = low.map((x, k) => x + (high[k]! - x) / 2) as unknown as Vec3;
    const half = Math.hypot(...low.map((x, k) => high[k]! - x)) / 2;
    return new ViewSpace(centre, half > 0 && Number.isFinite(half) ? 1 / half : 1, model.upAxis === 'z');
  }

  toView(point: Vec3, out = new Vector3()): Vector3 {
    const x = (point[0] - this.centre[0]) * this.scale;
    const y = (point[1] - this.centre[1]) * this.scale;
    const z = (point[2] - this.centre[2]) * this.scale;
    return this.zUp ? out.set(x, z, -y) : out.set(x, y, z);
  }

  toModel(point: Vector3): Vec3 {
    const [x, y, z] = this.directionToModel(point);
    return [
      this.centre[0] + x / this.scale,
      this.centre[1] + y / this.scale,
      this.centre[2] + z / this.scale,
    ];
  }

  /** Turns without moving or scaling. */
  directionToView([x, y, z]: Vec3, out = new Vector3()): Vector3 {
    return this.zUp ? out.set(x, z, -y) : out.set(x, y, z);
  }

  directionToModel({ x, y, z }: Vector3): Vec3 {
    return this.zUp ? [x, -z, y] : [x, y, z];
  }

  /** 3 per vertex, single precision; what is not finite is drawn at the centre. */
  place(positions: Float64Array, out: Float32Array): void {
    const [cx, cy, cz] = this.centre;
    const s = this.scale;
    for (let i = 0; i < positions.length; i += 3) {
      const x = (positions[i]! - cx) * s;
      const y = (positions[i + 1]! - cy) * s;
      const z = (positions[i + 2]! - cz) * s;
      const sum = x + y + z;
      const finite = sum - sum === 0;
      out[i] = finite ? x : 0;
      out[i + 1] = finite ? (this.zUp ? z : y) : 0;
      out[i + 2] = finite ? (this.zUp ? -y : z) : 0;
    }
  }

  /** The way back of `place`. */
  toModelAll(places: Float32Array): Float64Array {
    const out = new Float64Array(places.length);
    const point = new Vector3();
    for (let i = 0; i < places.length; i += 3) out.set(this.toModel(point.fromArray(places, i)), i);
    return out;
  }

  /** A frame of the model as the drawn object's position, turn and scale; the frame's own size is kept. */
  frameToView(frame: Matrix4, position: Vector3, turn: Quaternion, scale: Vector3): void {
    frame.decompose(position, turn, scale);
    this.toView([position.x, position.y, position.z], position);
    if (this.zUp) turn.premultiply(UPRIGHT);
  }

  frameToModel(position: Vector3, turn: Quaternion, scale: Vector3, out: Matrix4): Matrix4 {
    const q = turn.clone();
    if (this.zUp) q.premultiply(UPRIGHT.clone().invert());
    return out.compose(new Vector3(...this.toModel(position)), q, scale);
  }
}
