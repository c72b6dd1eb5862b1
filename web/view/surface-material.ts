import {
  Color,
  DataTexture,
  DoubleSide,
  type IUniform,
  LinearFilter,
  type Material,
  MeshMatcapMaterial,
  MeshStandardMaterial,
  type Side,
  SRGBColorSpace,
  Vector3,
  Vector4,
  type WebGLProgramParametersWithUniforms,
} from 'three';
import { heatTexels } from './heat';
import { matcapTexture } from './matcaps';
import type { ModelView } from './model-view';
import { CLAY, INTERIOR, LARGE, type Palette } from './palette';
import { CHANNELS, type Channel } from './region-channels';
import {
  FRAGMENT_DECLARATIONS,
  FRAGMENT_OVERLAY,
  fragmentColour,
  VERTEX_BODY,
  VERTEX_DECLARATIONS,
  VERTEX_DOT,
} from './surface-glsl';
import type { SurfaceShade } from './surface-shade';
import type { DisplayOptions, Hit } from './values';
import type { ViewSpace } from './view-space';

/** Over clay in either theme. */
const BRUSH_ADDS = '#ffffff';
const BRUSH_ERASES = '#ff7a72';

type SurfaceMaterial = MeshStandardMaterial | MeshMatcapMaterial;

const each = <T>(make: () => T): T[] => Array.from({ length: CHANNELS }, make);

/** The looks a surface can have, with one set of uniforms between them. */
export class SurfaceMaterials {
  readonly #heatMap = new DataTexture(heatTexels(256), 256, 1);
  readonly #made = new Map<DisplayOptions['shading'], SurfaceMaterial>();
  #shades: readonly SurfaceShade[] = [];
  /** The uniforms of all shades there have been. */
  readonly #relays: Record<string, IUniform> = {};

  readonly uniforms = {
    regionFill: { value: each(() => new Vector4()) },
    regionLine: { value: each(() => new Vector4()) },
    regionWidth: { value: each(() => 0) },
    regionCount: { value: 0 },
    pixelRatio: { value: 1 },
    heatShown: { value: false },
    heatMap: { value: this.#heatMap },
    paintShown: { value: false },
    interior: { value: new Color(INTERIOR) },
    inwards: { value: false },
    insideShown: { value: 1 },
    dotSize: { value: 0 },
    pixelsTall: { value: 1 },
    brushCentre: { value: new Vector3() },
    brushNormal: { value: new Vector3(0, 1, 0) },
    brushSide: { value: new Vector3(1, 0, 0) },
    brushColour: { value: new Vector3(1, 1, 1) },
    brushRadius: { value: 0 },
    brushDashed: { value: false },
  };

  constructor() {
    this.#heatMap.colorSpace = SRGBColorSpace;
    this.#heatMap.magFilter = LinearFilter;
    this.#heatMap.minFilter = LinearFilter;
    this.#heatMap.needsUpdate = true;
  }

  of({ shading, smooth: wanted }: Pick<DisplayOptions, 'shading' | 'smooth'>, side: Side): Material {
    // A dot has no slope on screen that a flat normal could be read from.
    const smooth = wanted || this.uniforms.dotSize.value > 0;
    const material = this.#made.get(shading) ?? this.#make(shading);
    this.#made.set(shading, material);
    if (material.flatShading === smooth || material.side !== side) {
      material.flatShading = !smooth;
      material.side = side;
      material.needsUpdate = true;
    }
    return material;
  }

  /** Which side is the inside, where there is one; and whether it is drawn as dots, which face the eye whatever is their inside. */
  setSides(view: Pick<ModelView, 'inwards' | 'insideUnknown' | 'dotSize'>): void {
    this.uniforms.inwards.value = view.inwards && view.dotSize === 0;
    this.uniforms.insideShown.value = view.insideUnknown ? 0 : 1;
    this.uniforms.dotSize.value = view.dotSize;
  }

  setChannels(channels: readonly Channel[], palette: Palette): void {
    const { regionFill, regionLine, regionWidth, regionCount } = this.uniforms;
    regionCount.value = channels.length;
    for (let i = 0; i < CHANNELS; i++) {
      const channel = channels[i];
      regionFill.value[i]!.set(0, 0, 0, 0);
      regionLine.value[i]!.set(0, 0, 0, 0);
      if (!channel) continue;
      // Paler than the line: a tint must not make the clay darker.
      const fill = new Color(palette.tints[channel.tint]).lerp(new Color(1, 1, 1), 0.07);
      const line = display(palette.tints[channel.tint]);
      const strength = LARGE.has(channel.tint) ? 0.66 : 0.72;
      regionFill.value[i]!.set(fill.r, fill.g, fill.b, channel.selected ? strength + 0.16 : strength);
      if (channel.selected) line.lerp(new Vector3(1, 1, 1), 0.55);
      regionLine.value[i]!.set(line.x, line.y, line.z, 1);
      regionWidth.value[i] = channel.selected ? 2 : 1.5;
    }
  }

  /** What layers add to the surfaces, as of the next picture. */
  setShades(shades: readonly SurfaceShade[]): void {
    const before = this.#shades;
    this.#shades = shades;
    for (const { uniforms } of shades)
      for (const name of Object.keys(uniforms)) this.#relays[name] ??= this.#relay(name);
    if (shades.length === before.length && shades.every(({ id }, i) => id === before[i]!.id)) return;
    for (const material of this.#made.values()) material.needsUpdate = true;
  }

  /** @returns whether the surfaces look different now */
  setBrush(
    brush: { readonly hit: Hit; readonly radius: number; readonly erase: boolean } | null,
    space: ViewSpace,
  ): boolean {
    const { brushCentre, brushNormal, brushSide, brushColour, brushRadius, brushDashed } = this.uniforms;
    if (!brush && brushRadius.value === 0) return false;
    brushRadius.value = brush ? brush.radius * space.scale : 0;
    if (brush) {
      space.toView(brush.hit.point, brushCentre.value);
      const normal = space.directionToView(brush.hit.normal, brushNormal.value);
      const apart = Math.abs(normal.y) < 0.9 ? new Vector3(0, 1, 0) : new Vector3(1, 0, 0);
      brushSide.value.crossVectors(apart, normal).normalize();
      brushDashed.value = brush.erase;
      brushColour.value.copy(display(brush.erase ? BRUSH_ERASES : BRUSH_ADDS));
    }
    return true;
  }

  dispose(): void {
    for (const material of this.#made.values()) {
      if (material instanceof MeshMatcapMaterial) material.matcap?.dispose();
      material.dispose();
    }
    this.#heatMap.dispose();
  }

  #make(shading: DisplayOptions['shading']): SurfaceMaterial {
    const material =
      shading === 'clay' || shading === 'vertex-colours'
        ? new MeshStandardMaterial({ color: CLAY, roughness: 0.65, metalness: 0 })
        : new MeshMatcapMaterial({ matcap: matcapTexture(shading) });
    // The lit side casts, or light leaks in where a thin surface meets another.
    material.shadowSide = DoubleSide;
    material.toneMapped = !(material instanceof MeshMatcapMaterial);
    material.onBeforeCompile = (shader) => this.#extend(shader);
    material.customProgramCacheKey = () => this.#shades.map(({ id }) => id).join();
    return material;
  }

  #extend(shader: WebGLProgramParametersWithUniforms): void {
    const shades = this.#shades;
    const all = (part: (shade: SurfaceShade) => string): string => shades.map(part).join('\n');
    Object.assign(shader.uniforms, this.uniforms as Record<string, IUniform>, this.#relays);
    const body = VERTEX_BODY + all(({ vertexBody }) => vertexBody);
    shader.vertexShader =
      VERTEX_DECLARATIONS +
      all(({ vertexDeclarations }) => vertexDeclarations) +
      after(after(shader.vertexShader, 'begin_vertex', body), 'project_vertex', VERTEX_DOT);
    shader.fragmentShader =
      FRAGMENT_DECLARATIONS +
      all(({ declarations }) => declarations) +
      [
        ['color_fragment', fragmentColour(all(({ colour }) => colour))] as const,
        ['lights_fragment_end', all(({ light }) => light)] as const,
        ['colorspace_fragment', all(({ finish = '' }) => finish) + FRAGMENT_OVERLAY] as const,
      ].reduce((source, [chunk, addition]) => after(source, chunk, addition), shader.fragmentShader);
  }

  /** Programs outlive the layers they were compiled for: a value is that of the layer that is there now. */
  #relay(name: string): IUniform {
    return Object.defineProperty({} as IUniform, 'value', {
      get: () => this.#shades.find(({ uniforms }) => name in uniforms)?.uniforms[name]?.value,
    });
  }
}

function after(source: string, chunk: string, addition: string): string {
  const include = `#include <${chunk}>`;
  return source.replace(include, `${include}\n${addition}`);
}

/** A CSS colour as the screen shows it, untouched by linear light. */
function display(css: string): Vector3 {
  const { r, g, b } = new Color(css).convertLinearToSRGB();
  return new Vector3(r, g, b);
}
