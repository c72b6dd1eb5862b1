import {
  BufferAttribute,
  CustomBlending,
  DoubleSide,
  Group,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  Mesh,
  MinEquation,
  ShaderMaterial,
  Vector2,
} from 'three';

/** Straight pieces to draw: all arrays count pieces, drawn units, display colours. */
export interface Segments {
  /** 6 per piece: from, to. */
  readonly ends: Float32Array;
  /** 4 per piece: rgb 0..1, width in CSS pixels. */
  readonly looks: Float32Array;
}

export const NO_SEGMENTS: Segments = { ends: new Float32Array(), looks: new Float32Array() };

interface Style {
  /** How strongly they show through what lies in front of them. */
  readonly hidden: number;
  readonly order: number;
  readonly arrows?: boolean;
  /** Pieces that lie over each other are no darker than one: for dark lines on pale ground. */
  readonly ink?: boolean;
  /** Drawn this much nearer to the eye, drawn units; a little nearer than the surface where left out. */
  readonly lift?: number;
}

/** Lines of constant width on the screen with soft edges and round ends. */
export class SegmentLines {
  readonly group = new Group();
  readonly #geometry = new InstancedBufferGeometry();
  readonly #materials: readonly ShaderMaterial[];

  constructor(style: Style) {
    const { hidden, order } = style;
    this.#geometry.setAttribute('position', new BufferAttribute(new Float32Array(CORNERS), 3));
    this.#geometry.setIndex([0, 1, 2, 2, 1, 3]);
    this.#materials = [material(hidden, false, style), material(1, true, style)];
    this.#materials.forEach((each, i) => {
      if (i === 0 && hidden === 0) return;
      const mesh = new Mesh(this.#geometry, each);
      mesh.frustumCulled = false;
      mesh.renderOrder = order + i;
      this.group.add(mesh);
    });
    this.group.visible = false;
  }

  set({ ends, looks }: Segments): void {
    // Attributes of another length are other buffers: the old ones go with the geometry's.
    this.#geometry.dispose();
    this.#geometry.setAttribute('from', new InstancedBufferAttribute(everyOther(ends, 0), 3));
    this.#geometry.setAttribute('to', new InstancedBufferAttribute(everyOther(ends, 3), 3));
    this.#geometry.setAttribute('look', new InstancedBufferAttribute(looks, 4));
    this.#geometry.instanceCount = looks.length / 4;
    this.group.visible = looks.length > 0;
  }

  /** @param width, height  CSS pixels */
  resize(width: number, height: number, pixelRatio: number): void {
    for (const { uniforms } of this.#materials) {
      uniforms.screen!.value.set(width, height);
      uniforms.pixelRatio!.value = pixelRatio;
    }
  }

  dispose(): void {
    this.#geometry.dispose();
    for (const each of this.#materials) each.dispose();
  }
}

const CORNERS = [-1, 0, 0, 1, 0, 0, -1, 1, 0, 1, 1, 0];

function everyOther(ends: Float32Array, start: number): Float32Array {
  const out = new Float32Array(ends.length / 2);
  for (let i = 0; i < out.length; i += 3) out.set(ends.subarray(2 * i + start, 2 * i + start + 3), i);
  return out;
}

function material(opacity: number, front: boolean, { arrows, ink, lift }: Style): ShaderMaterial {
  return new ShaderMaterial({
    transparent: true,
    ...(ink && { blending: CustomBlending, blendEquation: MinEquation }),
    side: DoubleSide,
    depthTest: front,
    depthWrite: false,
    toneMapped: false,
    defines: {
      ...(front && { FRONT: '' }),
      ...(arrows && { ARROWS: '' }),
      ...(ink && { INK: '' }),
      ...(lift && { LIFT: lift.toFixed(5) }),
    },
    uniforms: {
      opacity: { value: opacity },
      screen: { value: new Vector2(1, 1) },
      pixelRatio: { value: 1 },
    },
    vertexShader: /* glsl */ `
      attribute vec3 from;
      attribute vec3 to;
      attribute vec4 look;
      uniform vec2 screen;
      varying vec2 vAt;      // along and across, CSS pixels from the line's start
      varying float vLength;
      varying vec4 vLook;
      void main() {
        vec4 a = modelViewMatrix * vec4(from, 1.0);
        vec4 b = modelViewMatrix * vec4(to, 1.0);
        // What is behind the eye has no place on the screen: the line ends just before it.
        float near = -0.01;
        if (a.z > near && b.z < near) a = mix(a, b, (near - a.z) / (b.z - a.z));
        if (b.z > near && a.z < near) b = mix(b, a, (near - b.z) / (a.z - b.z));
        vec4 p = projectionMatrix * a;
        vec4 q = projectionMatrix * b;
        vec2 run = 0.5 * screen * (q.xy / q.w - p.xy / p.w);
        vLength = length(run);
        vec2 along = vLength > 1e-4 ? run / vLength : vec2(1.0, 0.0);
        float reach = 0.5 * look.w + 1.0;
        float end = position.y;
      #ifdef FRONT
        float beyond = reach;
      #else
        float beyond = 0.0; // pale ends must not lie over each other
      #endif
        vAt = vec2(end * vLength + (2.0 * end - 1.0) * beyond, position.x * reach);
        vLook = look;
        vec4 clip = mix(p, q, end);
        vec2 offset = along * (2.0 * end - 1.0) * beyond + vec2(-along.y, along.x) * vAt.y;
        clip.xy += offset * 2.0 / screen * clip.w;
      #ifdef LIFT
        // Towards the eye, so that it stays in its place on the screen.
        vec3 seen = mix(a, b, end).xyz;
        vec3 toEye = projectionMatrix[2][3] < 0.0 ? -normalize(seen) : vec3(0.0, 0.0, 1.0);
        vec4 raised = projectionMatrix * vec4(seen + LIFT * toEye, 1.0);
        clip.z = raised.z / raised.w * clip.w;
      #else
        clip.z -= 0.0012 * clip.w; // in front of the surface it lies on
      #endif
        gl_Position = clip;
      }`,
    fragmentShader: /* glsl */ `
      uniform float opacity;
      uniform float pixelRatio;
      varying vec2 vAt;
      varying float vLength;
      varying vec4 vLook;
      void main() {
        float half_ = 0.5 * vLook.w;
      #ifdef ARROWS
        half_ *= mix(1.0, 0.15, clamp(vAt.x / max(vLength, 1e-3), 0.0, 1.0));
      #endif
        float away = length(vec2(vAt.x - clamp(vAt.x, 0.0, vLength), vAt.y));
        float cover = clamp((half_ - away) * pixelRatio + 0.5, 0.0, 1.0);
      #ifdef INK
        gl_FragColor = vec4(mix(vec3(1.0), vLook.rgb, cover * opacity), 1.0);
      #else
        gl_FragColor = vec4(vLook.rgb, cover * opacity);
      #endif
      }`,
  });
}
