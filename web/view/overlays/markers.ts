import { BufferAttribute, BufferGeometry, Color, Group, Points, ShaderMaterial } from 'three';
import type { Layer, LayerContext, LayerKind } from '../layer';
import type { ModelView } from '../model-view';
import type { Palette } from '../palette';
import { ViewSpace } from '../view-space';
import type { MarkersPort, PointMarker } from './types';

/** Diameter in CSS pixels, outline included. */
const SIZE = 17;
/** Fingers and pens are less exact than this many CSS pixels. */
const REACH = 14;

/** Points of constant size on the screen, drawn over the model; paler where the model hides them. */
class Markers implements Layer, MarkersPort {
  readonly group = new Group();
  readonly #front = beads(1, true);
  readonly #behind = beads(0.3, false);
  readonly #geometry = new BufferGeometry();
  #shown: readonly PointMarker[] = [];
  #space = ViewSpace.identity;
  #model: ModelView | undefined;

  constructor(private readonly context: LayerContext) {
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
      (material.uniforms.colour!.value as Color).set(palette.tints.violet).convertLinearToSRGB();
    }
  }

  place(space: ViewSpace, model: ModelView | undefined): void {
    if (model !== this.#model) this.#shown = [];
    this.#space = space;
    this.#model = model;
    this.#draw();
  }

  resize(_width: number, _height: number, pixelRatio: number): void {
    for (const material of [this.#front, this.#behind]) material.uniforms.size!.value = SIZE * pixelRatio;
  }

  setMarkers(markers: readonly PointMarker[]): void {
    this.#shown = markers.filter((marker) => marker.visible);
    this.#draw();
    this.context.redraw();
  }

  pickMarker(x: number, y: number): string | null {
    let best: string | null = null;
    let nearest = REACH;
    for (const marker of this.#shown) {
      const at = this.context.onScreen(this.#space.toView(marker.position));
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

  #draw(): void {
    const places = new Float32Array(3 * this.#shown.length);
    this.#shown.forEach((marker, i) => {
      this.#space.toView(marker.position).toArray(places, 3 * i);
    });
    // Attributes of another length are other buffers: the old ones go with the geometry's.
    this.#geometry.dispose();
    this.#geometry.setAttribute('position', new BufferAttribute(places, 3));
    const chosen = Float32Array.from(this.#shown, (marker) => Number(marker.selected));
    this.#geometry.setAttribute('chosen', new BufferAttribute(chosen, 1));
    this.group.visible = this.#shown.length > 0;
  }
}

export const MARKERS: LayerKind<MarkersPort> = {
  id: 'markers',
  make: (context) => new Markers(context),
};

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
