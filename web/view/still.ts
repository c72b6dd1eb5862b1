import {
  ConstantAlphaFactor,
  CustomBlending,
  FramebufferTexture,
  HalfFloatType,
  Mesh,
  NearestFilter,
  NoBlending,
  OneMinusConstantAlphaFactor,
  OrthographicCamera,
  type PerspectiveCamera,
  PlaneGeometry,
  ShaderMaterial,
  type Texture,
  Vector2,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';

/**
 * The mean of many pictures of a scene at rest, each moved by a fraction of a pixel and with other places standing
 * for what is too thin to see: smooth edges and true transparency without sorting anything.
 */
export class StillPicture {
  readonly #camera = new OrthographicCamera(-1, 1, 1, -1, -1, 1);
  readonly #mean = new WebGLRenderTarget(1, 1, {
    type: HalfFloatType,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    depthBuffer: false,
  });
  #shot: FramebufferTexture | undefined;
  #width = 0;
  #height = 0;
  readonly #averaged = copier({
    blending: CustomBlending,
    blendSrc: ConstantAlphaFactor,
    blendDst: OneMinusConstantAlphaFactor,
  });
  readonly #present = copier({ blending: NoBlending });
  readonly #screen = new Mesh(new PlaneGeometry(2, 2));
  #count = 0;

  constructor() {
    this.#screen.frustumCulled = false;
  }

  /** Pictures in the mean. */
  get count(): number {
    return this.#count;
  }

  restart(): void {
    this.#count = 0;
  }

  static possible(renderer: WebGLRenderer): boolean {
    return renderer.extensions.has('EXT_color_buffer_float');
  }

  /**
   * Draws one more picture and leaves the mean on the canvas.
   *
   * @param render  draws picture `frame`, from 1
   */
  take(
    renderer: WebGLRenderer,
    camera: PerspectiveCamera | OrthographicCamera,
    render: (frame: number) => void,
  ): void {
    const { width, height } = renderer.domElement;
    const [x, y] = jitter(this.#count);
    camera.setViewOffset(width, height, x, y, width, height);
    render(this.#count + 1);
    camera.clearViewOffset();
    this.#add(renderer);
  }

  /** Puts the mean on the canvas. @returns false where there is none, or none of that size */
  show(renderer: WebGLRenderer): boolean {
    const { x: width, y: height } = renderer.getDrawingBufferSize(new Vector2());
    if (this.#count === 0 || this.#width !== width || this.#height !== height) return false;
    renderer.setRenderTarget(null);
    const clears = renderer.autoClear;
    renderer.autoClear = false;
    this.#draw(renderer, this.#present, this.#mean.texture);
    renderer.autoClear = clears;
    return true;
  }

  /** Takes the picture the canvas now holds into the mean and leaves the mean on the canvas. */
  #add(renderer: WebGLRenderer): void {
    const { x: width, y: height } = renderer.getDrawingBufferSize(new Vector2());
    if (!this.#shot || this.#width !== width || this.#height !== height) {
      this.#shot?.dispose();
      this.#shot = new FramebufferTexture(width, height);
      this.#mean.setSize(width, height);
      [this.#width, this.#height] = [width, height];
      this.#count = 0;
    }
    this.#count++;
    renderer.setRenderTarget(null);
    renderer.copyFramebufferToTexture(this.#shot);
    const clears = renderer.autoClear;
    renderer.autoClear = false;
    this.#averaged.blendAlpha = 1 / this.#count;
    renderer.setRenderTarget(this.#mean);
    this.#draw(renderer, this.#averaged, this.#shot);
    renderer.autoClear = clears;
    this.show(renderer);
  }

  dispose(): void {
    this.#shot?.dispose();
    this.#mean.dispose();
    this.#averaged.dispose();
    this.#present.dispose();
    this.#screen.geometry.dispose();
  }

  #draw(renderer: WebGLRenderer, material: ShaderMaterial, source: Texture): void {
    material.uniforms.source!.value = source;
    this.#screen.material = material;
    renderer.render(this.#screen, this.#camera);
  }
}

/** Places within a pixel, evenly spread however many are used: the (2, 3) sequence of Halton (1960). −½..½. */
export function jitter(index: number): readonly [number, number] {
  return [radicalInverse(index + 1, 2) - 0.5, radicalInverse(index + 1, 3) - 0.5];
}

function radicalInverse(index: number, base: number): number {
  let sum = 0;
  for (let digit = 1 / base, rest = index; rest > 0; rest = Math.floor(rest / base), digit /= base) {
    sum += (rest % base) * digit;
  }
  return sum;
}

function copier(blending: ConstructorParameters<typeof ShaderMaterial>[0]): ShaderMaterial {
  return new ShaderMaterial({
    ...blending,
    depthTest: false,
    depthWrite: false,
    toneMapped: false,
    uniforms: { source: { value: null } },
    vertexShader: 'void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }',
    fragmentShader: /* glsl */ `
      uniform sampler2D source;
      void main() { gl_FragColor = texelFetch(source, ivec2(gl_FragCoord.xy), 0); }`,
  });
}
