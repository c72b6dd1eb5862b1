import { DoubleSide, type Ray, Triangle, Vector3 } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import type { ModelView } from './model-view';
import type { Hit, Vec3 } from './values';

/** Rays and brushes against one model as it is posed. The tree is built when first needed. */
export class Picker {
  #tree: MeshBVH | undefined;
  #stale = false;

  constructor(private readonly view: ModelView) {}

  /** Builds or brings up to date what picking needs, so that the next pick is instant. */
  prepare(): void {
    if (this.view.model.triangles.length === 0) return;
    // Indirect: the file's order of faces is not ours to change.
    if (!this.#tree) this.#tree = new MeshBVH(this.view.surface, { indirect: true, setBoundingBox: false });
    else if (this.#stale) this.#tree.refit();
    this.#stale = false;
  }

  /** The vertices have come to rest elsewhere. */
  settle(): void {
    this.#stale = true;
  }

  /** @param ray  in drawn units */
  pick(ray: Ray): Hit | null {
    this.prepare();
    const found = this.#tree?.raycastFirst(ray, DoubleSide);
    if (!found || found.faceIndex == null) return null;
    return hitAt(this.view, found.faceIndex, found.point, ray.origin);
  }

  verticesWithin(hit: Hit, radius: number): Uint32Array {
    return this.view.graph.verticesInBall(
      this.view.posed,
      hit.triangle,
      hit.point as [number, number, number],
      radius,
    );
  }
}

/** A place on a triangle, found in drawn units, told in the model's own at full precision. */
export function hitAt(
  view: Pick<ModelView, 'model' | 'posed' | 'space' | 'surface'>,
  triangle: number,
  point: Vector3,
  eye: Vector3,
): Hit {
  const corners = [0, 1, 2].map((k) => view.model.triangles[3 * triangle + k]!) as [number, number, number];
  const drawn = view.surface.getAttribute('position');
  const [a, b, c] = corners.map((v) => new Vector3().fromBufferAttribute(drawn, v)) as [
    Vector3,
    Vector3,
    Vector3,
  ];
  const weights = Triangle.getBarycoord(point, a, b, c, new Vector3())?.toArray() ?? [1, 0, 0];
  const along = (k: number): number =>
    corners.reduce((sum, v, i) => sum + weights[i]! * view.posed[3 * v + k]!, 0);
  const normals = view.surface.getAttribute('normal');
  const normal = new Vector3();
  corners.forEach((v, i) => {
    normal.addScaledVector(new Vector3().fromBufferAttribute(normals, v), weights[i]!);
  });
  if (normal.lengthSq() === 0) Triangle.getNormal(a, b, c, normal);
  normal.normalize();
  const place: Vec3 = [along(0), along(1), along(2)];
  const gaps = [a, b, c].map((corner) => corner.distanceToSquared(point));
  const nearest = corners[gaps.indexOf(Math.min(...gaps))]!;
  return {
    point: place,
    normal: view.space.directionToModel(normal),
    triangle,
    vertex: nearest,
    distance: eye.distanceTo(point) / view.space.scale,
  };
}
