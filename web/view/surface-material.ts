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
import { CLAY, INTERIOR, type Palette } from './palette';
import { CHANNELS, type Channel } from './region-channels';
import {
  FRAGMENT_COLOUR,
  FRAGMENT_DECLARATIONS,
  FRAGMENT_OVERLAY,
  HAIR_DECLARATIONS,
  HAIR_SHADE,
  VERTEX_BODY,
  VERTEX_DECLARATIONS,
} from './surface-glsl';
import type { DisplayOptions } from './types';

type SurfaceMaterial = MeshStandardMaterial | MeshMatcapMaterial;

const each = <T>(make: () => T): T[] => Array.from({ length: CHANNELS }, make);

/** The looks a surface can have, with one set of uniforms between them. */
export class SurfaceMaterials {
  readonly #heatMap = new DataTexture(heatTexels(256), 256, 1);
  readonly #made = new Map<DisplayOptions['shading'], SurfaceMaterial>();
  #hair: Readonly<Record<string, IUniform>> | undefined;

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

  of({ shading, smooth }: Pick<DisplayOptions, 'shading' | 'smooth'>, side: Side): Material {
    const material = this.#made.get(shading) ?? this.#make(shading);
    this.#made.set(shading, material);
    if (material.flatShading === smooth || material.side !== side) {
      material.flatShading = !smooth;
      material.side = side;
      material.needsUpdate = true;
    }
    return material;
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
      const fill = new Color(palette.regions[channel.kind]).lerp(new Color(1, 1, 1), 0.07);
      const line = display(palette.regions[channel.kind]);
      const strength = channel.kind === 'roi' || channel.kind === 'scalp' ? 0.66 : 0.72;
      regionFill.value[i]!.set(fill.r, fill.g, fill.b, channel.selected ? strength + 0.16 : strength);
      if (channel.selected) line.lerp(new Vector3(1, 1, 1), 0.55);
      regionLine.value[i]!.set(line.x, line.y, line.z, 1);
      regionWidth.value[i] = channel.selected ? 2 : 1.5;
    }
  }

  /** @param uniforms  of the hair that stands between surface and light */
  setHair(uniforms: Readonly<Record<string, IUniform>> | undefined): void {
    if (this.#hair === uniforms) return;
    this.#hair = uniforms;
    for (const material of this.#made.values()) this.#useHair(material);
  }

  setBrushColour(colour: string): void {
    this.uniforms.brushColour.value.copy(display(colour));
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
    this.#useHair(material);
    return material;
  }

  #useHair(material: SurfaceMaterial): void {
    const { HAIR: _, ...defines } = material.defines ?? {};
    material.defines = this.#hair ? { ...defines, HAIR: '' } : defines;
    material.needsUpdate = true;
  }

  #extend(shader: WebGLProgramParametersWithUniforms): void {
    Object.assign(shader.uniforms, this.uniforms as Record<string, IUniform>, this.#hair);
    shader.vertexShader = VERTEX_DECLARATIONS + after(shader.vertexShader, 'begin_vertex', VERTEX_BODY);
    shader.fragmentShader =
      FRAGMENT_DECLARATIONS +
      HAIR_DECLARATIONS +
      [
        ['color_fragment', FRAGMENT_COLOUR] as const,
        ['lights_fragment_end', HAIR_SHADE] as const,
        ['colorspace_fragment', FRAGMENT_OVERLAY] as const,
      ].reduce((source, [chunk, addition]) => after(source, chunk, addition), shader.fragmentShader);
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
