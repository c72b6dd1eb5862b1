import {
  BackSide,
  BoxGeometry,
  Color,
  DirectionalLight,
  Group,
  HemisphereLight,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  PMREMGenerator,
  Scene,
  ShaderMaterial,
  SphereGeometry,
  type Texture,
  Vector3,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';

/** A lamp: a bright rectangle that looks at the middle of the room. Light in multiples of paper white. */
export interface SoftBox {
  readonly at: readonly [number, number, number];
  readonly size: readonly [number, number];
  readonly light: number;
  readonly colour: string;
}

export const SOFT_BOXES: readonly SoftBox[] = [
  { at: [0, 8, 1], size: [9, 7], light: 3.4, colour: '#fff8f0' },
  { at: [-7, 4.5, 5], size: [5, 5], light: 5.5, colour: '#fff4e8' },
  { at: [8, 2, 3], size: [3, 7], light: 1.7, colour: '#e4edff' },
  { at: [3, 4, -9], size: [6, 3], light: 5, colour: '#eef3ff' },
  { at: [-6, 3, -7], size: [2, 6], light: 3, colour: '#ffffff' },
];

/** Strength of the room's light beside the key. */
export const ENVIRONMENT = 0.62;
export const WALLS = { ceiling: [0.5, 0.51, 0.53], floor: [0.13, 0.12, 0.11] } as const;
/** Where the key light stands; the middle of the room is the model's. */
export const KEY = new Vector3(-2.2, 4, 2.6);
export const KEY_COLOUR = '#fff1e0';
export const KEY_INTENSITY = 2.1;
/** How far a shadow on the ground runs per unit of height. */
export const KEY_SLANT: readonly [x: number, z: number] = [-KEY.x / KEY.y, -KEY.z / KEY.y];

/** A photographer's room: soft boxes for the reflections and the fill, one key light that casts the shadow. */
export class Studio {
  readonly lights = new Group();
  readonly key = new DirectionalLight(KEY_COLOUR, KEY_INTENSITY);
  #room: WebGLRenderTarget | undefined;

  constructor(private readonly renderer: WebGLRenderer) {
    this.key.position.copy(KEY);
    this.key.castShadow = true;
    this.key.shadow.mapSize.set(2048, 2048);
    const frustum = this.key.shadow.camera;
    frustum.left = frustum.bottom = -1.7;
    frustum.right = frustum.top = 1.7;
    frustum.near = 0.5;
    frustum.far = 10;
    this.key.shadow.radius = 5;
    this.key.shadow.normalBias = 0.02;
    this.key.shadow.bias = -0.0004;
    this.lights.add(this.key, this.key.target);
  }

  /** The room as an environment map. Built anew after the graphics card has forgotten it. */
  environment(): Texture {
    const scene = roomScene();
    const generator = new PMREMGenerator(this.renderer);
    this.#room = generator.fromScene(scene, 0.03);
    generator.dispose();
    scene.traverse((part) => {
      if (!(part instanceof Mesh)) return;
      part.geometry.dispose();
      part.material.dispose();
    });
    return this.#room.texture;
  }

  dispose(): void {
    this.#room?.dispose();
    this.key.dispose();
  }
}

/** About as bright as the room, from above and below only. */
export const evenLight = (): HemisphereLight =>
  new HemisphereLight(new Color(...WALLS.ceiling), new Color(...WALLS.floor), 4);

function roomScene(): Scene {
  const scene = new Scene();
  const walls = new ShaderMaterial({
    side: BackSide,
    uniforms: {
      ceiling: { value: new Color(...WALLS.ceiling) },
      floor_: { value: new Color(...WALLS.floor) },
    },
    vertexShader: /* glsl */ `
      varying float height;
      void main() {
        height = normalize(position).y;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,
    fragmentShader: /* glsl */ `
      uniform vec3 ceiling, floor_;
      varying float height;
      void main() { gl_FragColor = vec4(mix(floor_, ceiling, smoothstep(-0.6, 0.8, height)), 1.0); }`,
  });
  scene.add(new Mesh(new SphereGeometry(20, 32, 16), walls));
  for (const box of SOFT_BOXES) {
    const material = new MeshBasicMaterial({ color: new Color(box.colour).multiplyScalar(box.light) });
    const lamp = new Mesh(new PlaneGeometry(...box.size), material);
    lamp.position.set(...box.at);
    lamp.lookAt(new Vector3());
    scene.add(lamp);
  }
  const table = new Mesh(
    new BoxGeometry(14, 0.2, 14),
    new MeshBasicMaterial({ color: new Color(0.17, 0.155, 0.145) }),
  );
  table.position.y = -4;
  scene.add(table);
  return scene;
}
