import { Color, GLSL3, Mesh, PlaneGeometry, ShaderMaterial } from 'three';

/** A vertical gradient behind everything, with a breath of noise so that it shows no bands. */
export class Background {
  readonly #material = new ShaderMaterial({
    glslVersion: GLSL3,
    depthTest: false,
    depthWrite: false,
    toneMapped: false,
    uniforms: { sky: { value: new Color() }, floor_: { value: new Color() } },
    vertexShader: /* glsl */ `
      out float height;
      void main() {
        height = position.y;
        gl_Position = vec4(2.0 * position.xy, 1.0, 1.0);
      }`,
    fragmentShader: /* glsl */ `
      uniform vec3 sky;
      uniform vec3 floor_;
      in float height;
      out vec4 colour;
      float noise(vec2 p) { return fract(52.9829189 * fract(dot(p, vec2(0.06711056, 0.00583715)))); }
      void main() {
        float t = smoothstep(-0.55, 0.55, height);
        colour = vec4(mix(floor_, sky, t) + (noise(gl_FragCoord.xy) - 0.5) / 255.0, 1.0);
      }`,
  });
  readonly mesh = new Mesh(new PlaneGeometry(1, 1), this.#material);

  constructor() {
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -1000;
  }

  /** @param sky, floor  CSS colours */
  set(sky: string, floor: string): void {
    // The gradient is mixed as the screen shows it.
    (this.#material.uniforms.sky!.value as Color).set(sky).convertLinearToSRGB();
    (this.#material.uniforms.floor_!.value as Color).set(floor).convertLinearToSRGB();
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.#material.dispose();
  }
}
