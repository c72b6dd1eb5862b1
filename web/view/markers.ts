import { BufferAttribute, BufferGeometry, Color, Group, Points, ShaderMaterial, type Vector3 } from 'three';
import type { Palette } from './palette';
import type { PointMarker } from './types';
import type { ViewSpace } from './view-space';

/** Diameter in CSS pixels, outline included. */
const SIZE = 17;

/** Points of constant size on the screen, drawn over the model; paler where the model hides them. */
export class Markers {
  readonly group = new Group();
  readonly #front = beads(1, true);
  readonly #behind = beads(0.3, false);
  readonly #geometry = new BufferGeometry();
  #shown: readonly PointMarker[] = [];

  constructor() {
    const behind = new Points(this.#geometry, this.#behind);
    const front = new Points(this.#geometry, this.#front);
    behind.renderOrder = 20;
    front.renderOrder = 21;
    this.group.add(behind, front);
    for (const points of [behind, front]) points.frustumCulled = false;
    this.group.visible = false;
  }

  setPalette(palette: Palette): void {
    for (const material of [this.#front, this.#behind]) {
      (material.uniforms.colour!.value as Color).set(palette.regions.handle).convertLinearToSRGB();
    }
  }

  set(markers: readonly PointMarker[], space: ViewSpace): void {
    this.#shown = markers.filter((marker) => marker.visible);
    const places = new Float32Array(3 * this.#shown.length);
    this.#shown.forEach((marker, i) => {
      space.toView(marker.position).toArray(places, 3 * i);
    });
    this.#geometry.setAttribute('position', new BufferAttribute(places, 3));
    const chosen = Float32Array.from(this.#shown, (marker) => Number(marker.selected));
    this.#geometry.setAttribute('chosen', new BufferAttribute(chosen, 1));
    this.group.visible = this.#shown.length > 0;
  }

  setPixelRatio(ratio: number): void {
    for (const material of [this.#front, this.#behind]) material.uniforms.size!.value = SIZE * ratio;
  }

  /**
   * The marker nearest to (x, y) within `reach` CSS pixels.
   *
   * @param project  drawn place to CSS pixels, z < 0 behind the eye
   */
  pick(
    x: number,
    y: number,
    reach: number,
    space: ViewSpace,
    project: (p: Vector3) => Vector3,
  ): string | null {
    let best: string | null = null;
    let nearest = reach;
    for (const marker of this.#shown) {
      const at = project(space.toView(marker.position));
      const gap = at.z < 0 ? Infinity : Math.hypot(at.x - x, at.y - y);
      if (gap > nearest) continue;
      nearest = gap;
      best = marker.id;
    }
    return best;
  }

  dispose(): void {
    this.#geometry.dispose();
    this.#front.dispose();
    this.#behind.dispose();
  }
}

function beads(opacity: number, depthTest: boolean): ShaderMaterial {
  return new ShaderMaterial({
    transparent: true,
    depthTest,
    depthWrite: false,
    toneMapped: false,
    uniforms: { size: { value: SIZE }, colour: { value: new Color() }, opacity: { value: opacity } },
    vertexShader: /* glsl */ `
      attribute float chosen;
      uniform float size;
      varying float vChosen;
      varying float vSize;
      void main() {
        vChosen = chosen;
        vSize = size * (1.0 + 0.25 * chosen);
        gl_PointSize = vSize;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
        gl_Position.z -= 0.0015 * gl_Position.w; // in front of the surface it sits on
      }`,
    fragmentShader: /* glsl */ `
      uniform vec3 colour;
      uniform float opacity;
      varying float vChosen;
      varying float vSize;
      void main() {
        vec2 p = 2.0 * gl_PointCoord - 1.0;
        float r = length(p);
        float pixel = 2.0 / vSize;
        float disc = clamp((1.0 - r) / pixel, 0.0, 1.0);
        float core = clamp((0.72 - r) / pixel + 0.5, 0.0, 1.0);
        float light = 0.86 + 0.3 * dot(vec3(p.x, -p.y, sqrt(max(0.0, 1.0 - r * r))), vec3(-0.4, 0.6, 0.69));
        vec3 bead = mix(colour, vec3(1.0), 0.18 + 0.25 * vChosen) * light;
        vec3 rim = mix(vec3(0.06, 0.06, 0.08), vec3(1.0), vChosen);
        gl_FragColor = vec4(mix(rim, bead, core), disc * opacity * mix(0.75, 1.0, core));
      }`,
  });
}
