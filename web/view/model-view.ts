import {
  BackSide,
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  DynamicDrawUsage,
  FrontSide,
  type GLBufferAttribute,
  Mesh,
  Points,
  type Side,
  Sphere,
  Vector3,
} from 'three';
import { DotScreen } from './dot-screen';
import { dotSize, isSoup } from './loose';
import { facesInwards, isClosed, VertexNormals } from './normals';
import { assignChannels, type Channel } from './region-channels';
import { SurfaceGraph } from './surface-graph';
import type { RegionPaint, ViewModel } from './values';
import { ViewSpace } from './view-space';

/** A surface as it is drawn, 3 numbers each, drawn units. */
export interface DrawnShape {
  readonly places: Float32Array;
  readonly normals: Float32Array;
}

/** One model on the graphics card: places, normals and the fields its look is made of. */
export class ModelView {
  /** What is drawn. */
  readonly geometry = new BufferGeometry();
  /** Places, normals and triangles as they were last set, whatever is drawn meanwhile: for picking. */
  readonly surface = new BufferGeometry();
  /** In the scene: the surface, or for a model without faces its points. */
  readonly mesh: Mesh | Points;
  /** Diameter of the points that are drawn, drawn units; 0: a surface is. */
  readonly dotSize: number;
  /** Its triangles have no common inside: a soup, or points without any. */
  readonly insideUnknown: boolean;
  readonly space: ViewSpace;
  /** Encloses space with its faces turned inwards. */
  readonly inwards: boolean;
  /** Has an outside only: nobody sees its inner side. */
  readonly closed: boolean;
  readonly #dots: BufferGeometry | undefined;
  readonly #screen: DotScreen | undefined;
  readonly #normals: VertexNormals;
  readonly #position: BufferAttribute;
  readonly #normal: BufferAttribute;
  #graph: SurfaceGraph | undefined;
  readonly #masks = new WeakMap<Uint32Array, ReturnType<SurfaceGraph['softMask']>>();
  readonly #touch = new WeakMap<Uint32Array, WeakMap<Uint32Array, boolean>>();

  constructor(readonly model: ViewModel) {
    const count = model.positions.length / 3;
    this.space = ViewSpace.around(model);
    this.posed = model.positions;
    this.#position = new BufferAttribute(new Float32Array(3 * count), 3).setUsage(DynamicDrawUsage);
    this.#normal = new BufferAttribute(new Float32Array(3 * count), 3).setUsage(DynamicDrawUsage);
    for (const geometry of [this.geometry, this.surface]) {
      geometry.setIndex(new BufferAttribute(model.triangles, 1));
      geometry.setAttribute('position', this.#position);
      geometry.setAttribute('normal', this.#normal);
    }
    for (const name of ['regionsLow', 'regionsHigh']) {
      this.geometry.setAttribute(name, new BufferAttribute(new Uint8Array(4 * count), 4, true));
    }
    if (model.colors) this.geometry.setAttribute('paint', new BufferAttribute(model.colors, 4, true));
    this.#normals = new VertexNormals(model.triangles, model.welded);
    const isCloud = model.faceOffsets.length <= 1;
    this.#dots = isCloud ? dotsOf(this.geometry) : undefined;
    this.mesh = this.#dots ? new Points(this.#dots) : new Mesh(this.geometry);
    this.#screen = isCloud ? new DotScreen(this.geometry) : undefined;
    if (this.#screen) this.mesh.add(this.#screen.mesh);
    this.mesh.renderOrder = isCloud ? 1.5 : 0;
    // The drawn size is known, and live changes of shape must not wait for new bounds.
    this.geometry.boundingSphere = new Sphere(new Vector3(), 4);
    this.mesh.frustumCulled = false;
    this.setPositions(model.positions);
    this.closed = isClosed(model.triangles, model.welded);
    this.inwards = facesInwards(this.#position.array as Float32Array, model.triangles);
    this.dotSize = isCloud ? dotSize(this.#position.array as Float32Array, model.triangles) : 0;
    this.insideUnknown = isCloud || isSoup(model.triangles, model.welded);
    this.#screen?.setBehind(2.5 * this.dotSize);
    // Shadows are looked up a little outside of a surface, which a turned triangle has on its other side.
    this.mesh.castShadow = !isCloud;
    this.mesh.receiveShadow = !this.insideUnknown;
  }

  /** Places as now shown, model space. */
  posed: Float64Array;

  /** Closed surfaces show one side: at their outline the far side would flicker through the near one. */
  get side(): Side {
    if (!this.closed || this.#dots) return DoubleSide;
    return this.inwards ? BackSide : FrontSide;
  }

  get graph(): SurfaceGraph {
    this.#graph ??= new SurfaceGraph(this.model.triangles, this.model.welded);
    return this.#graph;
  }

  setPositions(positions: Float64Array): void {
    this.posed = positions;
    this.#draw(positions, this.#position.array as Float32Array, this.#normal.array as Float32Array);
    this.#position.needsUpdate = true;
    this.#normal.needsUpdate = true;
  }

  /** Places and normals as they were last set, drawn units. */
  drawn(): DrawnShape {
    return {
      places: this.#position.array as Float32Array,
      normals: this.#normal.array as Float32Array,
    };
  }

  /** Places and normals as they would be drawn, drawn units. */
  drawnAt(positions: Float64Array): DrawnShape {
    const places = new Float32Array(positions.length);
    const normals = new Float32Array(positions.length);
    this.#draw(positions, places, normals);
    return { places, normals };
  }

  /** Draws vertices that are kept elsewhere, until `drawOwn`. */
  drawOther(position: GLBufferAttribute, normal: GLBufferAttribute): void {
    // three takes them, its types do not.
    this.#setDrawn('position', position as unknown as BufferAttribute);
    this.#setDrawn('normal', normal as unknown as BufferAttribute);
  }

  drawOwn(): void {
    this.#setDrawn('position', this.#position);
    this.#setDrawn('normal', this.#normal);
  }

  /** @returns what each channel now holds, for the material's colours */
  setRegions(regions: readonly RegionPaint[]): Channel[] {
    const channels = assignChannels(regions, (a, b) => this.#touching(a.vertices, b.vertices));
    const low = this.geometry.getAttribute('regionsLow') as BufferAttribute;
    const high = this.geometry.getAttribute('regionsHigh') as BufferAttribute;
    for (const attribute of [low, high]) {
      (attribute.array as Uint8Array).fill(0);
      attribute.needsUpdate = true;
    }
    channels.forEach((channel, index) => {
      const array = (index < 4 ? low : high).array as Uint8Array;
      for (const region of channel.regions) {
        const { vertices, values } = this.#mask(region.vertices);
        for (let i = 0; i < vertices.length; i++) {
          const at = 4 * vertices[i]! + (index % 4);
          array[at] = Math.max(array[at]!, Math.round(255 * values[i]!));
        }
      }
    });
    return channels;
  }

  setHeat(values: Float32Array, [low, high]: readonly [number, number]): void {
    const attribute =
      (this.geometry.getAttribute('heat') as BufferAttribute | undefined) ??
      new BufferAttribute(new Float32Array(values.length), 1).setUsage(DynamicDrawUsage);
    const span = high > low ? 1 / (high - low) : 0;
    const array = attribute.array as Float32Array;
    for (let v = 0; v < array.length; v++) array[v] = ((values[v] ?? 0) - low) * span;
    attribute.needsUpdate = true;
    this.#setDrawn('heat', attribute);
  }

  /** The posed vertices (or some of them), 3 numbers each, in drawn units. */
  places(vertices?: Uint32Array): Float32Array {
    const all = this.#position.array as Float32Array;
    if (!vertices) return all;
    const out = new Float32Array(3 * vertices.length);
    for (let i = 0; i < vertices.length; i++) {
      const v = 3 * vertices[i]!;
      out.set(all.subarray(v, v + 3), 3 * i);
    }
    return out;
  }

  dispose(): void {
    // What is drawn from elsewhere is freed there.
    this.drawOwn();
    this.geometry.dispose();
    this.#dots?.dispose();
    this.#screen?.dispose();
  }

  #setDrawn(name: string, attribute: BufferAttribute): void {
    for (const geometry of [this.geometry, this.#dots]) geometry?.setAttribute(name, attribute);
  }

  #draw(positions: Float64Array, places: Float32Array, normals: Float32Array): void {
    this.space.place(positions, places);
    this.#normals.compute(places, normals);
  }

  #mask(set: Uint32Array): ReturnType<SurfaceGraph['softMask']> {
    let mask = this.#masks.get(set);
    if (!mask) {
      mask = this.graph.softMask(set);
      this.#masks.set(set, mask);
    }
    return mask;
  }

  #touching(a: Uint32Array, b: Uint32Array): boolean {
    const known = this.#touch.get(a)?.get(b);
    if (known !== undefined) return known;
    const answer = this.graph.touching(a, b);
    if (!this.#touch.has(a)) this.#touch.set(a, new WeakMap());
    this.#touch.get(a)!.set(b, answer);
    return answer;
  }
}

/** The vertices of a geometry, each once, with all that is known of them. */
function dotsOf(geometry: BufferGeometry): BufferGeometry {
  const dots = new BufferGeometry();
  for (const [name, attribute] of Object.entries(geometry.attributes)) dots.setAttribute(name, attribute);
  return dots;
}
