import { BufferAttribute, BufferGeometry, Color, DoubleSide, Group, Mesh, ShaderMaterial } from 'three';
import { heatColour } from '../heat';
import type { ViewSpace } from '../view-space';
import { SegmentLines } from './segments';
import type { Box, FieldSample, SupportSurface } from './types';

/** CSS pixels. */
const ARROW = 3;
const EDGE = 1.25;
const BOX_COLOUR = '#98a2ae';
const CONSTRAINT_COLOUR = '#e3b341';
const SUPPORT_COLOUR = '#4f8cff';

/** What can be shown of how the hair comes about: field, volume, the surface that strokes fall on. */
export class GuideOverlay {
  readonly group = new Group();
  readonly #arrows = new SegmentLines({ hidden: 0, order: 10, arrows: true });
  readonly #asked = new SegmentLines({ hidden: 0, order: 11, arrows: true });
  readonly #edges = new SegmentLines({ hidden: 0.4, order: 12 });
  readonly #support = new Mesh(new BufferGeometry(), supportMaterial());
  #field: FieldSample | null = null;
  #constraints: FieldSample | null = null;
  #box: Box | null = null;
  #surface: SupportSurface | null = null;

  constructor() {
    this.#support.visible = false;
    this.#support.frustumCulled = false;
    this.#support.renderOrder = 8;
    this.group.add(this.#arrows.group, this.#asked.group, this.#edges.group, this.#support);
  }

  setField(field: FieldSample | null, space: ViewSpace): void {
    this.#field = field;
    this.#arrows.set(field ? arrows(field, space) : NOTHING);
  }

  setConstraints(constraints: FieldSample | null, space: ViewSpace): void {
    this.#constraints = constraints;
    const colour = new Color(CONSTRAINT_COLOUR).convertLinearToSRGB();
    this.#asked.set(constraints ? arrows(constraints, space, () => colour) : NOTHING);
  }

  setVolume(box: Box | null, space: ViewSpace): void {
    this.#box = box;
    this.#edges.set(box ? edges(box, space) : NOTHING);
  }

  setSupport(surface: SupportSurface | null, space: ViewSpace): void {
    this.#surface = surface;
    this.#support.visible = surface !== null;
    const geometry = this.#support.geometry;
    geometry.dispose();
    if (!surface) return;
    const places = new Float32Array(surface.positions.length);
    space.place(surface.positions, places);
    geometry.setAttribute('position', new BufferAttribute(places, 3));
    geometry.setIndex(new BufferAttribute(surface.triangles, 1));
    geometry.computeVertexNormals();
  }

  /** Draws the same in another space. */
  place(space: ViewSpace): void {
    this.setField(this.#field, space);
    this.setConstraints(this.#constraints, space);
    this.setVolume(this.#box, space);
    this.setSupport(this.#surface, space);
  }

  setSize(width: number, height: number, pixelRatio: number): void {
    for (const lines of [this.#arrows, this.#asked, this.#edges]) {
      lines.setSize(width, height);
      lines.setPixelRatio(pixelRatio);
    }
  }

  dispose(): void {
    this.#arrows.dispose();
    this.#asked.dispose();
    this.#edges.dispose();
    this.#support.geometry.dispose();
    this.#support.material.dispose();
  }
}

const NOTHING = { ends: new Float32Array(), looks: new Float32Array() };

/** Long arrows warm, short ones cool. */
const byLength = (share: number): Color => new Color(...heatColour(share)).convertLinearToSRGB();

/** @param colourOf  by length, as a share of the longest */
function arrows(
  { places, vectors }: FieldSample,
  space: ViewSpace,
  colourOf: (share: number) => Color = byLength,
): typeof NOTHING {
  const count = Math.floor(Math.min(places.length, vectors.length) / 3);
  const lengths = Float64Array.from({ length: count }, (_, i) =>
    Math.hypot(vectors[3 * i]!, vectors[3 * i + 1]!, vectors[3 * i + 2]!),
  );
  const longest = lengths.reduce((most, length) => Math.max(most, length), 0) || 1;
  const ends = new Float32Array(6 * count);
  const looks = new Float32Array(4 * count);
  for (let i = 0; i < count; i++) {
    const [x, y, z] = [places[3 * i]!, places[3 * i + 1]!, places[3 * i + 2]!];
    const tip = [x + vectors[3 * i]!, y + vectors[3 * i + 1]!, z + vectors[3 * i + 2]!] as const;
    ends.set([...space.toView([x, y, z]), ...space.toView(tip)], 6 * i);
    looks.set([...colourOf(lengths[i]! / longest), ARROW], 4 * i);
  }
  return { ends, looks };
}

function edges({ low, high }: Box, space: ViewSpace): typeof NOTHING {
  const corner = (bits: number): number[] => [
    ...space.toView([(bits & 1 ? high : low)[0], (bits & 2 ? high : low)[1], (bits & 4 ? high : low)[2]]),
  ];
  const pairs = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((bits) =>
    [1, 2, 4].filter((bit) => (bits & bit) === 0).map((bit) => [...corner(bits), ...corner(bits | bit)]),
  );
  const colour = new Color(BOX_COLOUR).convertLinearToSRGB().toArray();
  return {
    ends: Float32Array.from(pairs.flat()),
    looks: Float32Array.from(pairs.flatMap(() => [...colour, EDGE])),
  };
}

/** Glass: clearest where one looks straight through it. */
function supportMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    transparent: true,
    depthWrite: false,
    side: DoubleSide,
    toneMapped: false,
    uniforms: { colour: { value: new Color(SUPPORT_COLOUR).convertLinearToSRGB() } },
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
