import { Color, Mesh, PlaneGeometry, ShaderMaterial, Vector2 } from 'three';
import type { Palette } from './palette';
import type { ViewSpace } from './view-space';

/** How far the grid reaches, in drawn units (the model's half diagonal is 1). */
const REACH = 9;

/** Lines on the ground at round distances of the model's unit, fading with distance and where they crowd. */
export class Grid {
  readonly #material = new ShaderMaterial({
    transparent: true,
    depthWrite: false,
    toneMapped: false,
    uniforms: {
      colour: { value: new Color() },
      axisX: { value: new Color() },
      axisZ: { value: new Color() },
      strength: { value: 0.2 },
      cell: { value: 0.1 },
      origin: { value: new Vector2() },
      axes: { value: new Vector2(1, 1) },
      reach: { value: REACH },
    },
    vertexShader: /* glsl */ `
      varying vec3 place;
      void main() {
        place = (modelMatrix * vec4(position, 1.0)).xyz;
        gl_Position = projectionMatrix * viewMatrix * vec4(place, 1.0);
      }`,
    fragmentShader: /* glsl */ `
      uniform vec3 colour, axisX, axisZ;
      uniform float strength, cell, reach;
      uniform vec2 origin, axes;
      varying vec3 place;
      // How much of this pixel a line of every whole c covers; gone before neighbours would blur together.
      float lines(vec2 c) {
        vec2 width = fwidth(c);
        vec2 away = abs(fract(c - 0.5) - 0.5) / width;
        vec2 cover = clamp(1.0 - away, 0.0, 1.0) * (1.0 - smoothstep(0.08, 0.4, width));
        return max(cover.x, cover.y);
      }
      void main() {
        vec2 p = place.xz - origin;
        float far = length(place.xz) / reach;
        vec3 toEye = normalize(cameraPosition - place);
        float fade = pow(max(0.0, 1.0 - far), 2.2) * smoothstep(0.0, 0.22, abs(toEye.y));
        float cover = max(0.5 * lines(p / cell), lines(p / (10.0 * cell)));
        vec3 shade = colour;
        vec2 width = fwidth(p);
        vec2 axis = axes * clamp(1.25 - abs(p) / width, 0.0, 1.0);
        if (axis.y > 0.0) { shade = axisX; cover = max(cover, axis.y * 1.3); }
        if (axis.x > 0.0) { shade = axisZ; cover = max(cover, axis.x * 1.3); }
        gl_FragColor = vec4(shade, min(1.0, cover * strength) * fade);
        #include <colorspace_fragment>
      }`,
  });
  readonly mesh = new Mesh(new PlaneGeometry(2 * REACH, 2 * REACH), this.#material);

  constructor() {
    this.mesh.rotation.x = -Math.PI / 2;
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -10;
  }

  setPalette(palette: Palette): void {
    const { colour, axisX, axisZ, strength } = this.#material.uniforms;
    (colour!.value as Color).set(palette.grid);
    (axisX!.value as Color).set(palette.axes[0]);
    (axisZ!.value as Color).set(palette.axes[2]);
    strength!.value = palette.gridStrength;
  }

  /** @param ground  height of the ground, drawn units */
  place(space: ViewSpace, ground: number): void {
    const cell = 10 ** Math.floor(Math.log10(0.6 / space.scale));
    const { cell: drawn, origin, axes } = this.#material.uniforms;
    drawn!.value = cell * space.scale;
    // Lines pass through multiples of ten cells of the model's own axes, which may lie far away.
    const across = space.directionToView(space.centre);
    const offset = (x: number): number => -(x % (10 * cell)) * space.scale;
    (origin!.value as Vector2).set(offset(across.x), offset(across.z));
    const near = (x: number): number =>
      Math.abs(x) * space.scale < REACH && Math.abs(x) < 10 * cell ? 1 : 0;
    (axes!.value as Vector2).set(near(across.x), near(across.z));
    this.mesh.position.y = ground;
    this.mesh.updateMatrixWorld();
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.#material.dispose();
  }
}
