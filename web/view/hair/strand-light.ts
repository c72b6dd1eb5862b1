import {
  Color,
  HalfFloatType,
  type IUniform,
  Mesh,
  NearestFilter,
  OrthographicCamera,
  type PerspectiveCamera,
  PlaneGeometry,
  ShaderMaterial,
  Vector3,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { FILL_LIGHT, GROUND, KEY_LIGHT, SKY, SOFT_LIGHTS } from './lights';
import { ROW } from './quantise';
import { LIGHT_FRAGMENT } from './shade-glsl';

/**
 * The light each point of each strand sends to the eye, found once per point and camera: the many pictures of
 * a camera at rest draw ribbons only.
 */
export class StrandLight {
  readonly #camera = new OrthographicCamera();
  readonly #target = new WebGLRenderTarget(ROW, 1, {
    type: HalfFloatType,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    depthBuffer: false,
  });
  readonly #look = {
    hairColour: { value: new Color() },
    colourVariation: { value: 0 },
    natural: { value: true },
  };
  readonly #eye = {
    eyePlace: { value: new Vector3() },
    eyeBack: { value: new Vector3() },
    eyeFar: { value: false },
  };
  readonly #screen: Mesh<PlaneGeometry, ShaderMaterial>;
  readonly texture = { value: this.#target.texture };
  /** Rows that hold the light of what is as it was. */
  #valid = 0;

  /** @param uniforms  points, opacity maps and light grid */
  constructor(uniforms: Readonly<Record<string, IUniform>>) {
    this.#target.scissorTest = true;
    const material = new ShaderMaterial({
      depthTest: false,
      depthWrite: false,
      vertexShader: 'void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }',
      fragmentShader: LIGHT_FRAGMENT,
      uniforms: {
        ...uniforms,
        ...this.#look,
        ...this.#eye,
        keyDirection: { value: KEY_LIGHT.towards },
        keyLight: { value: KEY_LIGHT.light },
        softDirection: { value: SOFT_LIGHTS.map(({ towards }) => towards) },
        softLight: { value: SOFT_LIGHTS.map(({ light }) => light) },
        softSpread: { value: SOFT_LIGHTS.map(({ spread }) => spread) },
        fillDirection: { value: FILL_LIGHT.towards },
        fillLight: { value: FILL_LIGHT.light },
        fillSpread: { value: FILL_LIGHT.spread },
        skyLight: { value: SKY },
        groundLight: { value: GROUND },
      },
    });
    this.#screen = new Mesh(new PlaneGeometry(2, 2), material);
    this.#screen.frustumCulled = false;
  }

  setLook(color: string, variation: number): void {
    this.#look.hairColour.value.set(color);
    this.#look.colourVariation.value = variation;
    this.#valid = 0;
  }

  setNatural(natural: boolean): void {
    this.#look.natural.value = natural;
    this.#valid = 0;
  }

  /** Strands or light are others. */
  changed(): void {
    this.#valid = 0;
  }

  /** @param rows  of points, of which the first `wanted` will be drawn */
  update(
    renderer: WebGLRenderer,
    camera: PerspectiveCamera | OrthographicCamera,
    rows: number,
    wanted: number,
  ): void {
    const { eyePlace, eyeBack, eyeFar } = this.#eye;
    const place = camera.getWorldPosition(new Vector3());
    const back = camera.getWorldDirection(new Vector3()).negate();
    const far = camera instanceof OrthographicCamera;
    const moved = far ? !back.equals(eyeBack.value) : !place.equals(eyePlace.value);
    if (this.#target.height !== rows) this.#target.setSize(ROW, rows);
    else if (!moved && far === eyeFar.value && wanted <= this.#valid) return;
    eyePlace.value.copy(place);
    eyeBack.value.copy(back);
    eyeFar.value = far;
    this.#target.scissor.set(0, 0, ROW, wanted);
    renderer.setRenderTarget(this.#target);
    renderer.render(this.#screen, this.#camera);
    renderer.setRenderTarget(null);
    this.#valid = wanted;
  }

  dispose(): void {
    this.#target.dispose();
    this.#screen.geometry.dispose();
    this.#screen.material.dispose();
  }
}
