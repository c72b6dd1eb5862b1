import { BufferAttribute, BufferGeometry, Color, DoubleSide, Group, Mesh, ShaderMaterial } from 'three';
import type { Layer, LayerContext, LayerKind } from '../layer';
import { ViewSpace } from '../view-space';
import type { SupportPort, SupportSurface } from './types';

const COLOUR = '#4f8cff';

/** The surface that strokes fall on. */
class SupportOverlay implements Layer, SupportPort {
  readonly group = new Group();
  readonly aid = true;
  readonly #mesh = new Mesh(new BufferGeometry(), glass());
  #surface: SupportSurface | null = null;
  #space = ViewSpace.identity;

  constructor(private readonly context: LayerContext) {
    this.#mesh.visible = false;
    this.#mesh.frustumCulled = false;
    this.#mesh.renderOrder = 8;
    this.group.add(this.#mesh);
  }

  place(space: ViewSpace): void {
    this.#space = space;
    this.#draw();
  }

  setSupport(surface: SupportSurface | null): void {
    this.#surface = surface;
    this.#draw();
    this.context.redraw();
  }

  dispose(): void {
    this.#mesh.geometry.dispose();
    this.#mesh.material.dispose();
  }

  #draw(): void {
    const surface = this.#surface;
    const { geometry } = this.#mesh;
    this.#mesh.visible = surface !== null;
    geometry.dispose();
    if (!surface) return;
    const places = new Float32Array(surface.positions.length);
    this.#space.place(surface.positions, places);
    geometry.setAttribute('position', new BufferAttribute(places, 3));
    geometry.setIndex(new BufferAttribute(surface.triangles, 1));
    geometry.computeVertexNormals();
  }
}

export const SUPPORT: LayerKind<SupportPort> = {
  id: 'support',
  make: (context) => new SupportOverlay(context),
};

/** Glass: clearest where one looks straight through it. */
function glass(): ShaderMaterial {
  return new ShaderMaterial({
    transparent: true,
    depthWrite: false,
    side: DoubleSide,
    toneMapped: false,
    uniforms: { colour: { value: new Color(COLOUR).convertLinearToSRGB() } },
    vertexShader: /* glsl */ `
      varying vec3 vNormal_;
      varying vec3 vEye;
      void main() {
        vec4 seen = modelViewMatrix * vec4(position, 1.0);
        vNormal_ = normalMatrix * normal;
        vEye = isOrthographic ? vec3(0.0, 0.0, 1.0) : -seen.xyz;
        gl_Position = projectionMatrix * seen;
      }`,
    fragmentShader: /* glsl */ `
      uniform vec3 colour;
      varying vec3 vNormal_;
      varying vec3 vEye;
      void main() {
        float facing = abs(dot(normalize(vNormal_), normalize(vEye)));
        gl_FragColor = vec4(mix(vec3(1.0), colour, 0.75), mix(0.5, 0.16, facing));
      }`,
  });
}
