import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Group,
  Mesh,
  MeshStandardMaterial,
  type ShaderMaterial,
  Sphere,
  Vector3,
} from 'three';
import { heatColour } from '../heat';
import type { Layer, LayerContext, LayerKind } from '../layer';
import { VertexNormals } from '../normals';
import type { Palette } from '../palette';
import { ViewSpace } from '../view-space';
import { glass } from './glass';
import type { Companion, CompanionsPort } from './types';

/** Dyed, so that what is worn is told from the clay of who wears it, and one garment from the next. */
const DYES = ['#6d84ad', '#5f8f83', '#9a7396', '#a98a5f'] as const;
const ROUGHNESS = 0.75;

interface Drawn {
  readonly of: Companion;
  readonly mesh: Mesh<BufferGeometry, MeshStandardMaterial | ShaderMaterial>;
}

/** Other models that stand where they are beside the one on screen: to be seen, not to be picked. */
class Companions implements Layer, CompanionsPort {
  readonly group = new Group();
  #drawn: readonly Drawn[] = [];
  #space = ViewSpace.identity;
  #accent: Color | undefined;

  constructor(private readonly context: LayerContext) {}

  place(space: ViewSpace): void {
    if (space === this.#space) return;
    this.#space = space;
    const shown = this.#drawn.map(({ of }) => of);
    this.#clear();
    this.setCompanions(shown);
  }

  setCompanions(companions: readonly Companion[]): void {
    const before = new Map(this.#drawn.map((drawn) => [drawn.of.id, drawn]));
    this.#drawn = companions.map((companion) => {
      const held = before.get(companion.id);
      const isSame =
        held?.of.positions === companion.positions &&
        held.of.triangles === companion.triangles &&
        held.of.look === companion.look &&
        held.of.dye === companion.dye &&
        held.of.heat === companion.heat;
      if (isSame) before.delete(companion.id);
      return isSame ? held : this.#draw(companion);
    });
    for (const { mesh } of before.values()) this.#drop(mesh);
    this.context.reshaped();
    this.context.redraw();
  }

  setPalette(palette: Palette): void {
    this.#accent = new Color(palette.tints.azure).convertLinearToSRGB();
    for (const { mesh } of this.#drawn) if ('uniforms' in mesh.material) this.#tint(mesh.material);
  }

  dispose(): void {
    this.#clear();
  }

  #draw(of: Companion): Drawn {
    const places = new Float32Array(of.positions.length);
    this.#space.place(of.positions, places);
    const facing = new Float32Array(places.length);
    const welded = Int32Array.from({ length: places.length / 3 }, (_, v) => v);
    new VertexNormals(of.triangles, welded).compute(places, facing);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(places, 3));
    geometry.setAttribute('normal', new BufferAttribute(facing, 3));
    geometry.setIndex(new BufferAttribute(of.triangles, 1));
    geometry.boundingSphere = new Sphere(new Vector3(), Infinity);
    if (of.heat) geometry.setAttribute('color', new BufferAttribute(heatColours(of.heat), 3));
    const mesh = new Mesh(geometry, of.look === 'ghost' ? glass() : cloth(of));
    if ('uniforms' in mesh.material) this.#tint(mesh.material);
    mesh.frustumCulled = false;
    mesh.castShadow = of.look !== 'ghost';
    mesh.receiveShadow = mesh.castShadow;
    if (of.look === 'ghost') mesh.renderOrder = 8;
    this.group.add(mesh);
    return { of, mesh };
  }

  #tint({ uniforms }: ShaderMaterial): void {
    if (this.#accent) (uniforms.colour!.value as Color).copy(this.#accent);
  }

  #drop(mesh: Drawn['mesh']): void {
    this.group.remove(mesh);
    mesh.geometry.dispose();
    mesh.material.dispose();
  }

  #clear(): void {
    for (const { mesh } of this.#drawn) this.#drop(mesh);
    this.#drawn = [];
  }
}

function cloth({ dye = 0, heat }: Companion): MeshStandardMaterial {
  return new MeshStandardMaterial({
    color: heat ? '#ffffff' : DYES[dye % DYES.length]!,
    vertexColors: heat !== undefined,
    roughness: ROUGHNESS,
    metalness: 0,
    side: DoubleSide,
    // What lies closer than its triangles are flat is drawn as lying over; by slopes as well, triangles that are seen edge-on would show.
    polygonOffset: true,
    polygonOffsetFactor: 0,
    polygonOffsetUnits: -400,
  });
}

function heatColours({ values, range: [low, high] }: NonNullable<Companion['heat']>): Float32Array {
  const colours = new Float32Array(3 * values.length);
  for (const [v, value] of values.entries())
    colours.set(heatColour(high > low ? (value - low) / (high - low) : 0.5), 3 * v);
  return colours;
}

export const COMPANIONS: LayerKind<CompanionsPort> = {
  id: 'companions',
  make: (context) => new Companions(context),
};
