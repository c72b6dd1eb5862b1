import {
  type Box3,
  type BufferGeometry,
  Color,
  CustomBlending,
  DepthTexture,
  DoubleSide,
  FloatType,
  HalfFloatType,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  NearestFilter,
  OneFactor,
  OrthographicCamera,
  ShaderMaterial,
  Vector3,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { OPACITY_FRAGMENT, OPACITY_VERTEX } from './shade-glsl';

const TEXELS = 1024;
/** The first layer's thickness as a share of the map's depth. */
const LAYER = 1 / 90;
const TO_TEXTURE = new Matrix4().set(0.5, 0, 0, 0.5, 0, 0.5, 0, 0.5, 0, 0, 0.5, 0.5, 0, 0, 0, 1);

/**
 * How deep in the hair a place lies, seen from the key light: Yuksel & Keyser, "Deep opacity maps" (2008).
 * The light does not move with the eye, so the maps are drawn anew only when the hair or the head changes.
 */
export class OpacityMap {
  readonly #camera = new OrthographicCamera();
  readonly #front = depthTarget();
  readonly #head = depthTarget();
  readonly #layers = new WebGLRenderTarget(TEXELS, TEXELS, {
    type: HalfFloatType,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    depthBuffer: false,
  });
  readonly #nearest: ShaderMaterial;
  readonly #opacity: ShaderMaterial;
  readonly #strands: Mesh;
  readonly #solid = new Mesh(undefined, new MeshBasicMaterial({ colorWrite: false, side: DoubleSide }));

  /** What surfaces and strands need to look the light up. */
  readonly uniforms = {
    opacityFront: { value: this.#front.depthTexture },
    opacityLayers: { value: this.#layers.texture },
    headFront: { value: this.#head.depthTexture },
    lightMatrix: { value: new Matrix4() },
    layerStep: { value: LAYER },
  };

  /** @param strandUniforms  those of the ribbons; `pixels` is the map's own */
  constructor(geometry: BufferGeometry, strandUniforms: ShaderMaterial['uniforms']) {
    const own = { ...strandUniforms, pixels: { value: TEXELS } };
    this.#nearest = new ShaderMaterial({
      uniforms: own,
      vertexShader: OPACITY_VERTEX,
      fragmentShader: 'void main() { gl_FragColor = vec4(1.0); }',
      side: DoubleSide,
      colorWrite: false,
    });
    this.#opacity = new ShaderMaterial({
      uniforms: { ...own, front: this.uniforms.opacityFront, layerStep: this.uniforms.layerStep },
      vertexShader: OPACITY_VERTEX,
      fragmentShader: OPACITY_FRAGMENT,
      side: DoubleSide,
      depthTest: false,
      depthWrite: false,
      transparent: true,
      blending: CustomBlending,
      blendSrc: OneFactor,
      blendDst: OneFactor,
    });
    this.#strands = new Mesh(geometry, this.#nearest);
    this.#strands.frustumCulled = false;
    this.#solid.frustumCulled = false;
  }

  /**
   * @param box     the hair's
   * @param towards unit vector to the light
   * @param head    what else stands in the light
   */
  update(renderer: WebGLRenderer, box: Box3, towards: Vector3, head: BufferGeometry | undefined): void {
    this.#aim(box, towards);
    const clear = renderer.getClearColor(new Color());
    const alpha = renderer.getClearAlpha();
    renderer.setClearColor(0, 0);
    this.#draw(renderer, this.#front, this.#nearest);
    this.#draw(renderer, this.#layers, this.#opacity);
    renderer.setRenderTarget(this.#head);
    renderer.clear();
    if (head) {
      this.#solid.geometry = head;
      renderer.render(this.#solid, this.#camera);
    }
    renderer.setRenderTarget(null);
    renderer.setClearColor(clear, alpha);
  }

  dispose(): void {
    for (const target of [this.#front, this.#head, this.#layers]) {
      target.depthTexture?.dispose();
      target.dispose();
    }
    this.#nearest.dispose();
    this.#opacity.dispose();
    (this.#solid.material as MeshBasicMaterial).dispose();
  }

  #draw(renderer: WebGLRenderer, target: WebGLRenderTarget, material: ShaderMaterial): void {
    this.#strands.material = material;
    renderer.setRenderTarget(target);
    renderer.clear();
    renderer.render(this.#strands, this.#camera);
  }

  #aim(box: Box3, towards: Vector3): void {
    const centre = box.getCenter(new Vector3());
    const radius = Math.max(1e-4, 0.5 * box.getSize(new Vector3()).length()) * 1.02;
    const camera = this.#camera;
    camera.left = camera.bottom = -radius;
    camera.right = camera.top = radius;
    // From the light's side of everything drawn: the head may stand before its hair.
    camera.near = 0.1;
    camera.far = 0.1 + 2 * radius + 2;
    camera.position.copy(centre).addScaledVector(towards, radius + 2.1);
    camera.up.set(0, 1, 0);
    camera.lookAt(centre);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    // The same thickness whatever the box.
    this.uniforms.layerStep.value = (LAYER * 2 * radius) / (camera.far - camera.near);
    this.uniforms.lightMatrix.value
      .copy(TO_TEXTURE)
      .multiply(camera.projectionMatrix)
      .multiply(camera.matrixWorldInverse);
  }
}

function depthTarget(): WebGLRenderTarget {
  const target = new WebGLRenderTarget(TEXELS, TEXELS, {
    minFilter: NearestFilter,
    magFilter: NearestFilter,
  });
  target.depthTexture = new DepthTexture(TEXELS, TEXELS, FloatType);
  return target;
}
