import {
  type BufferGeometry,
  Color,
  DoubleSide,
  HalfFloatType,
  Mesh,
  OrthographicCamera,
  PlaneGeometry,
  ShaderMaterial,
  Vector2,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';

/** Side of the square of ground that is looked at, drawn units. */
const SIDE = 5;
const TEXELS = 512;

export interface ShadowShape {
  /** What stands higher than this above the ground no longer darkens it. */
  readonly height: number;
  /** How quickly darkness fades with height. */
  readonly falloff: number;
  /** Ground passed per unit of height: where the light comes from. */
  readonly slant: readonly [x: number, z: number];
  /** Widths of successive blurs, in texels. */
  readonly blurs: readonly number[];
}

/**
 * A soft shadow on the ground: the model's underside seen from below, near parts dark, blurred. Drawn again
 * only when the shape changes; orbiting costs one textured square.
 */
export class GroundShadow {
  readonly #camera = new OrthographicCamera(-SIDE / 2, SIDE / 2, SIDE / 2, -SIDE / 2, 0, 4);
  readonly #target = new WebGLRenderTarget(TEXELS, TEXELS, { type: HalfFloatType });
  readonly #swap = new WebGLRenderTarget(TEXELS, TEXELS, { type: HalfFloatType });
  readonly #depth = new ShaderMaterial({
    side: DoubleSide,
    uniforms: {
      ground: { value: 0 },
      height: { value: 1 },
      falloff: { value: 1 },
      slant: { value: new Vector2() },
    },
    vertexShader: /* glsl */ `
      uniform float ground;
      uniform vec2 slant;
      varying float above;
      void main() {
        above = position.y - ground;
        vec3 thrown = position;
        thrown.xz += slant * above;
        vec4 seen = modelViewMatrix * vec4(thrown, 1.0);
        gl_Position = projectionMatrix * seen;
      }`,
    fragmentShader: /* glsl */ `
      uniform float height, falloff;
      varying float above;
      void main() { gl_FragColor = vec4(vec3(0.0), pow(clamp(1.0 - above / height, 0.0, 1.0), falloff)); }`,
  });
  readonly #caster = new Mesh(undefined, this.#depth);
  readonly #blur = new ShaderMaterial({
    depthTest: false,
    depthWrite: false,
    uniforms: { source: { value: null }, step_: { value: new Vector2() } },
    vertexShader: /* glsl */ `
      varying vec2 at;
      void main() { at = uv; gl_Position = vec4(2.0 * position.xy, 0.0, 1.0); }`,
    fragmentShader: /* glsl */ `
      uniform sampler2D source;
      uniform vec2 step_;
      varying vec2 at;
      void main() {
        float sum = 0.0, weight = 0.0;
        for (int i = -6; i <= 6; i++) {
          float w = exp(-float(i * i) / 14.0);
          sum += w * texture2D(source, at + float(i) * step_).a;
          weight += w;
        }
        gl_FragColor = vec4(vec3(0.0), sum / weight);
      }`,
  });
  readonly #screen = new Mesh(new PlaneGeometry(1, 1), this.#blur);
  readonly #material = new ShaderMaterial({
    transparent: true,
    depthWrite: false,
    toneMapped: false,
    uniforms: { source: { value: this.#target.texture }, strength: { value: 0.6 } },
    vertexShader: /* glsl */ `
      varying vec2 at;
      void main() { at = uv; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`,
    fragmentShader: /* glsl */ `
      uniform sampler2D source;
      uniform float strength;
      varying vec2 at;
      void main() {
        vec2 edge = smoothstep(vec2(0.0), vec2(0.12), at) * smoothstep(vec2(0.0), vec2(0.12), 1.0 - at);
        gl_FragColor = vec4(vec3(0.0), strength * edge.x * edge.y * texture2D(source, vec2(at.x, 1.0 - at.y)).a);
      }`,
  });
  readonly mesh = new Mesh(new PlaneGeometry(SIDE, SIDE), this.#material);

  constructor(private readonly shape: ShadowShape) {
    const { height, falloff, slant } = this.#depth.uniforms;
    height!.value = shape.height;
    falloff!.value = shape.falloff;
    slant!.value.set(...shape.slant);
    this.mesh.rotation.x = -Math.PI / 2;
    this.mesh.renderOrder = -20;
    // Looks up with x to the right, z up: the ground's own picture upside down.
    this.#camera.rotation.x = Math.PI / 2;
    this.#screen.frustumCulled = false;
    this.#caster.frustumCulled = false;
  }

  setStrength(strength: number): void {
    this.#material.uniforms.strength!.value = strength;
  }

  /** @param ground  height of the ground, drawn units */
  update(renderer: WebGLRenderer, model: BufferGeometry, ground: number): void {
    this.mesh.position.y = ground;
    this.#camera.position.y = ground - 1e-3;
    this.#depth.uniforms.ground!.value = ground;
    this.#caster.geometry = model;
    const shadows = renderer.shadowMap.autoUpdate;
    const clear = renderer.getClearColor(new Color());
    const alpha = renderer.getClearAlpha();
    renderer.shadowMap.autoUpdate = false;
    renderer.setClearColor(0, 0);
    renderer.setRenderTarget(this.#target);
    renderer.clear();
    renderer.render(this.#caster, this.#camera);
    for (const width of this.shape.blurs) {
      this.#pass(renderer, this.#target, this.#swap, new Vector2(width / TEXELS, 0));
      this.#pass(renderer, this.#swap, this.#target, new Vector2(0, width / TEXELS));
    }
    renderer.setRenderTarget(null);
    renderer.setClearColor(clear, alpha);
    renderer.shadowMap.autoUpdate = shadows;
  }

  dispose(): void {
    for (const part of [this.#target, this.#swap, this.#depth, this.#blur, this.#material]) part.dispose();
    this.#screen.geometry.dispose();
    this.mesh.geometry.dispose();
  }

  #pass(renderer: WebGLRenderer, from: WebGLRenderTarget, to: WebGLRenderTarget, step: Vector2): void {
    this.#blur.uniforms.source!.value = from.texture;
    this.#blur.uniforms.step_!.value = step;
    renderer.setRenderTarget(to);
    renderer.clear();
    renderer.render(this.#screen, this.#camera);
  }
}
