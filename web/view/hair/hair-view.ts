import {
  Box3,
  BufferAttribute,
  type BufferGeometry,
  Color,
  CustomBlending,
  Data3DTexture,
  DataTexture,
  DoubleSide,
  InstancedBufferGeometry,
  LinearFilter,
  Mesh,
  OneFactor,
  type OrthographicCamera,
  type PerspectiveCamera,
  RedFormat,
  RGBAFormat,
  RGBAIntegerFormat,
  ShaderMaterial,
  UnsignedShortType,
  Vector2,
  Vector3,
  type WebGLRenderer,
  ZeroFactor,
} from 'three';
import type { Strands } from '../../core/strands';
import type { ViewSpace } from '../view-space';
import { bakeLight, type Head } from './baked-light';
import { KEY_LIGHT } from './lights';
import { type Prefix, prefixOf } from './lod';
import { OpacityMap } from './opacity-map';
import { fitting, pack, ROW } from './quantise';
import { type EvenStrands, resample } from './resample';
import { rootDensity } from './rooted';
import { SHADE_FRAGMENT, SHADE_VERTEX } from './shade-glsl';
import { StrandLight } from './strand-light';
import { hairShade } from './surface-shade';
import type { HairOptions } from './types';

/** Strands whose light is not in the grid yet. */
interface Unbaked {
  readonly even: EvenStrands;
  readonly taper: number;
  readonly head: Head | undefined;
}

const WHITE = new Color(1, 1, 1);
/** Shadows need no more strands than this: they stand for all. */
const SHADOW_STRANDS = 30_000;

/** One head of hair on the graphics card. */
export class HairView {
  readonly #geometry = new InstancedBufferGeometry();
  readonly #points = new DataTexture(new Uint16Array(4), 1, 1, RGBAIntegerFormat, UnsignedShortType);
  readonly #light = volume(RGBAFormat);
  readonly #shade = volume(RedFormat);
  readonly #box = new Box3();
  readonly #ribbon = {
    strandPoints: { value: this.#points },
    boxLow: { value: new Vector3() },
    boxSize: { value: new Vector3(1, 1, 1) },
    perStrand: { value: 2 },
    rootWidth: { value: 0 },
    taper: { value: 1 },
  };
  readonly #frame = { pixels: { value: 1 }, frame: { value: 0 } };
  readonly #grid = { gridLow: { value: new Vector3() }, gridSize: { value: 1 } };
  readonly #opacity = new OpacityMap(this.#geometry, this.#ribbon);
  readonly #strandLight = new StrandLight({
    ...this.#ribbon,
    ...this.#grid,
    ...this.#opacity.uniforms,
    lightGrid: { value: this.#light },
  });
  readonly #material: ShaderMaterial;
  readonly mesh: Mesh;
  readonly #tint = { value: new Color() };
  /** For the surfaces that hair shades. */
  readonly shade = hairShade({
    ...this.#opacity.uniforms,
    hairShade: { value: this.#shade },
    hairShadeLow: this.#grid.gridLow,
    hairShadeSize: this.#grid.gridSize,
    hairTint: this.#tint,
  });

  #total = 0;
  #width = 0;
  #options: HairOptions = { show: true, shading: 'natural', widthScale: 1 };
  #share = 1;
  /** Strands in the opacity map. */
  #shadowing = 0;
  #stale = false;
  #unbaked: Unbaked | undefined;
  #baked = false;

  /** @param multisampled  whether the picture has several samples a pixel */
  constructor(multisampled: boolean) {
    this.#points.internalFormat = 'RGBA16UI';
    this.#material = new ShaderMaterial({
      side: DoubleSide,
      alphaToCoverage: multisampled,
      // After the ground, which would otherwise lie over long hair; it still hides and is hidden by depth.
      transparent: true,
      // Alpha chooses samples; the picture itself stays opaque.
      blending: CustomBlending,
      blendSrc: OneFactor,
      blendDst: ZeroFactor,
      blendSrcAlpha: ZeroFactor,
      blendDstAlpha: OneFactor,
      vertexShader: SHADE_VERTEX,
      fragmentShader: SHADE_FRAGMENT,
      uniforms: {
        ...this.#ribbon,
        ...this.#frame,
        strandLight: this.#strandLight.texture,
        multisampled: { value: multisampled },
      },
    });
    this.mesh = new Mesh(this.#geometry, this.#material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 5;
    this.mesh.visible = false;
  }

  /** Strands on the card. */
  get total(): number {
    return this.#total;
  }

  get shown(): boolean {
    return this.mesh.visible;
  }

  /** Drawn units; empty without hair. */
  get box(): Box3 {
    return this.#box;
  }

  /** @param rows  the card's largest texture */
  set(strands: Strands, space: ViewSpace, head: Head | undefined, rows: number): void {
    const most = fitting(64, rows);
    const even = resample(strands, space, most);
    const packed = pack(even, strands.groups);
    this.#total = even.count;
    this.#box.min.set(...even.low);
    this.#box.max.set(...even.high);
    this.#upload(packed.texels, packed.rows);
    this.#ribbon.boxLow.value.set(...packed.low);
    this.#ribbon.boxSize.value.set(...packed.size);
    if (this.#ribbon.perStrand.value !== even.perStrand || !this.#geometry.index) this.#shape(even.perStrand);
    this.#ribbon.perStrand.value = even.perStrand;
    const { look } = strands;
    this.#width = look.thickness * space.scale;
    this.#ribbon.taper.value = look.taper;
    this.#strandLight.setLook(look.color, look.colorVariation);
    this.#tint.value.set(look.color).lerp(WHITE, 0.15);
    this.#unbaked = { even, taper: look.taper, head };
    this.#stale = true;
    this.#apply();
  }

  clear(): void {
    this.#total = 0;
    this.#box.makeEmpty();
    this.#unbaked = undefined;
    this.#baked = false;
    this.#upload(new Uint16Array(4 * ROW), 1);
    this.#apply();
  }

  setOptions(options: Partial<HairOptions>): void {
    this.#options = { ...this.#options, ...options };
    this.#strandLight.setNatural(this.#options.shading === 'natural');
    if (options.widthScale !== undefined) this.#stale = true;
    this.#apply();
  }

  /** The share of strands in the pictures to come. */
  setShare(share: number): void {
    if (share === this.#share) return;
    this.#share = share;
    this.#apply();
  }

  /** The opacity map is drawn again with the next picture: the head has moved, the card has forgotten. */
  lightChanged(): void {
    this.#stale = true;
  }

  /** @param frame  of a resting picture, 0 for a moving one */
  prepare(
    renderer: WebGLRenderer,
    camera: PerspectiveCamera | OrthographicCamera,
    frame: number,
    head: BufferGeometry | undefined,
  ): void {
    if (!this.shown) return;
    this.#frame.frame.value = frame;
    // While a stroke is drawn the light of a moment ago will do.
    if (this.#unbaked && (frame > 0 || !this.#baked)) this.#bake(this.#unbaked);
    const prefix = prefixOf(this.#total, this.#share);
    const shadowing = Math.min(SHADOW_STRANDS, prefix.count);
    if (this.#stale || (frame > 0 && shadowing > this.#shadowing)) {
      this.#draw(prefixOf(this.#total, shadowing / this.#total));
      this.#opacity.update(renderer, this.#box, KEY_LIGHT.towards, head);
      this.#strandLight.changed();
      this.#shadowing = shadowing;
      this.#stale = false;
    }
    const wanted = Math.ceil((prefix.count * this.#ribbon.perStrand.value) / ROW);
    this.#strandLight.update(renderer, camera, this.#points.image.height, wanted);
    this.#draw(prefix);
    this.#frame.pixels.value = renderer.getDrawingBufferSize(new Vector2()).y;
  }

  dispose(): void {
    for (const part of [
      this.#geometry,
      this.#points,
      this.#light,
      this.#shade,
      this.#opacity,
      this.#strandLight,
      this.#material,
    ])
      part.dispose();
  }

  #bake({ even, taper, head }: Unbaked): void {
    const baked = bakeLight(even, this.#width * this.#options.widthScale, taper, head);
    fill(this.#light, baked.light, baked.n);
    fill(this.#shade, baked.shade, baked.n);
    if (head) setRooted(head.geometry, rootDensity(even, head.places));
    this.#grid.gridLow.value.set(...baked.low);
    this.#grid.gridSize.value = baked.size;
    this.#strandLight.changed();
    this.#unbaked = undefined;
    this.#baked = true;
  }

  #apply(): void {
    this.mesh.visible = this.#total > 0 && this.#options.show;
    this.#draw(prefixOf(this.#total, this.#share));
  }

  #draw({ count, widthScale }: Prefix): void {
    this.#geometry.instanceCount = count;
    this.#ribbon.rootWidth.value = this.#width * this.#options.widthScale * widthScale;
  }

  #upload(texels: Uint16Array, rows: number): void {
    const image = this.#points.image;
    // A texture's storage is fixed: another size is another texture.
    if (image.height !== rows || image.width !== ROW) this.#points.dispose();
    this.#points.image = { data: texels, width: ROW, height: rows };
    this.#points.needsUpdate = true;
  }

  /** Two vertices per point: side and number. The places come from the texture. */
  #shape(perStrand: number): void {
    const corners = new Float32Array(6 * perStrand);
    const index = new Uint16Array(6 * (perStrand - 1));
    for (let i = 0; i < perStrand; i++) {
      corners.set([-1, i, 0, 1, i, 0], 6 * i);
      const v = 2 * i;
      if (i < perStrand - 1) index.set([v, v + 1, v + 2, v + 2, v + 1, v + 3], 6 * i);
    }
    this.#geometry.dispose();
    this.#geometry.setAttribute('position', new BufferAttribute(corners, 3));
    this.#geometry.setIndex(new BufferAttribute(index, 1));
  }
}

/** Part of the head's own geometry, and freed with it. */
function setRooted(geometry: BufferGeometry, values: Uint8Array<ArrayBuffer>): void {
  const held = geometry.getAttribute('rooted') as BufferAttribute | undefined;
  if (!held) geometry.setAttribute('rooted', new BufferAttribute(values, 1, true));
  else {
    (held.array as Uint8Array).set(values);
    held.needsUpdate = true;
  }
}

function volume(format: typeof RGBAFormat | typeof RedFormat): Data3DTexture {
  const texture = new Data3DTexture(new Uint8Array(format === RGBAFormat ? 4 : 1), 1, 1, 1);
  texture.format = format;
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.unpackAlignment = 1;
  texture.needsUpdate = true;
  return texture;
}

function fill(texture: Data3DTexture, values: Uint8Array, n: number): void {
  if (texture.image.width !== n) texture.dispose();
  texture.image = { data: values, width: n, height: n, depth: n };
  texture.needsUpdate = true;
}
