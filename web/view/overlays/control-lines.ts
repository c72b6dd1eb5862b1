import { BufferAttribute, BufferGeometry, Color, Group, Points, ShaderMaterial } from 'three';
import type { Layer, LayerContext, LayerKind } from '../layer';
import { ViewSpace } from '../view-space';
import { nearestOnSegment } from './on-segment';
import { SegmentLines } from './segments';
import type { ControlHit, ControlLine, ControlLinesPort } from './types';

const COLOURS: Readonly<Record<ControlLine['tint'], string>> = {
  blue: '#4f8cff',
  yellow: '#e3b341',
  violet: '#a566ff',
  green: '#4cc38a',
  cyan: '#3fc3d8',
  coral: '#ff6b6b',
};
/** CSS pixels. */
const WIDTH = 2.5;
const BEAD = 9;
const POINT_REACH = 11;
const LINE_REACH = 8;
/** A bead under the pointer is as large as one that is taken up. */
const UNDER = 1.5;

interface Look {
  /** How strongly lines and points show through what lies in front of them. */
  readonly hidden: number;
  /** Diameter of a point in CSS pixels. */
  readonly bead: number;
}

/** Lines over everything, with a bead for each of their points. */
class ControlLineOverlay implements Layer, ControlLinesPort {
  readonly group = new Group();
  readonly aid = true;
  readonly #lines: SegmentLines;
  readonly #beadGeometry = new BufferGeometry();
  readonly #front: ShaderMaterial;
  readonly #behind: ShaderMaterial;
  #shown: readonly ControlLine[] = [];
  #space = ViewSpace.identity;

  constructor(
    private readonly context: LayerContext,
    private readonly look: Look,
  ) {
    this.#lines = new SegmentLines({ hidden: look.hidden, order: 30 });
    this.#front = beads(1, true);
    this.#behind = beads(look.hidden, false);
    [this.#behind, this.#front].forEach((material, i) => {
      const points = new Points(this.#beadGeometry, material);
      points.frustumCulled = false;
      points.renderOrder = 32 + i;
      this.group.add(points);
    });
    this.group.add(this.#lines.group);
    this.group.visible = false;
  }

  place(space: ViewSpace): void {
    this.#space = space;
    this.#draw();
  }

  resize(width: number, height: number, pixelRatio: number): void {
    this.#lines.resize(width, height, pixelRatio);
    for (const material of [this.#front, this.#behind])
      material.uniforms.size!.value = this.look.bead * pixelRatio;
  }

  setLines(lines: readonly ControlLine[]): void {
    this.#shown = lines;
    this.#draw();
    this.context.redraw();
  }

  pickLine(x: number, y: number): ControlHit | null {
    return pickLine(this.#shown, x, y, (point) => this.context.onScreen(this.#space.toView(point)));
  }

  dispose(): void {
    for (const part of [this.#lines, this.#beadGeometry, this.#front, this.#behind]) part.dispose();
  }

  #draw(): void {
    const ends: number[] = [];
    const looks: number[] = [];
    const places: number[] = [];
    const tints: number[] = [];
    for (const line of this.#shown) {
      const { points, smooth = points, tint: name, selected, plain, chosen, joints, under } = line;
      const lit = selected || under === 'line';
      const tint = shown(name, lit);
      const width = lit ? 1.4 * WIDTH : WIDTH;
      const drawn = smooth.map((point) => this.#space.toView(point));
      drawn.slice(1).forEach((to, i) => {
        ends.push(...drawn[i]!, ...to);
        looks.push(...tint, width);
      });
      if (plain) continue;
      points.forEach((point, i) => {
        places.push(...this.#space.toView(point));
        const bead = shown(joints?.includes(i) ? 'yellow' : name, lit || i === under);
        const state = chosen === undefined ? Number(lit) : i === chosen ? 2 : 0;
        tints.push(...bead, i === under ? Math.max(UNDER, state) : state);
      });
    }
    this.#lines.set({ ends: Float32Array.from(ends), looks: Float32Array.from(looks) });
    this.#beadGeometry.dispose();
    this.#beadGeometry.setAttribute('position', new BufferAttribute(Float32Array.from(places), 3));
    this.#beadGeometry.setAttribute('tint', new BufferAttribute(Float32Array.from(tints), 4));
    this.group.visible = this.#shown.length > 0;
  }
}

/** On a surface: paler where something hides them. */
export const CONTROL_LINES: LayerKind<ControlLinesPort> = {
  id: 'control-lines',
  make: (context) => new ControlLineOverlay(context, { hidden: 0.35, bead: BEAD }),
};

/** Inside a model: seen through it, with points large enough to be taken hold of. */
export const INNER_LINES: LayerKind<ControlLinesPort> = {
  id: 'inner-lines',
  make: (context) => new ControlLineOverlay(context, { hidden: 0.92, bead: 1.4 * BEAD }),
};

/** The nearest control point in reach, else the nearest line in reach. */
export function pickLine(
  lines: readonly ControlLine[],
  x: number,
  y: number,
  project: (point: ControlLine['points'][number]) => { x: number; y: number; z: number },
): ControlHit | null {
  let point: ControlHit | null = null;
  let line: ControlHit | null = null;
  let nearestPoint = POINT_REACH;
  let nearestLine = LINE_REACH;
  for (const { id, plain, points, smooth = points } of lines) {
    if (plain) continue;
    const last = points.length - 2;
    points.map(project).forEach((at, i) => {
      const gap = at.z < 0 ? Infinity : Math.hypot(at.x - x, at.y - y);
      if (gap > nearestPoint) return;
      nearestPoint = gap;
      point = { id, point: i, segment: Math.max(0, Math.min(i, last)) };
    });
    const seen = smooth.map(project);
    const pieces = (seen.length - 1) / (points.length - 1);
    seen.slice(1).forEach((b, i) => {
      const a = seen[i]!;
      if (a.z < 0 || b.z < 0) return;
      const { distance } = nearestOnSegment(a, b, x, y);
      if (distance > nearestLine) return;
      nearestLine = distance;
      line = { id, point: null, segment: Math.floor(i / pieces) };
    });
  }
  return point ?? line;
}

/** As the screen shows it. */
function shown(tint: ControlLine['tint'], selected: boolean): [number, number, number] {
  const colour = new Color(COLOURS[tint]).convertLinearToSRGB();
  if (selected) colour.lerp(new Color(1, 1, 1), 0.45);
  return colour.toArray() as [number, number, number];
}

function beads(opacity: number, depthTest: boolean): ShaderMaterial {
  return new ShaderMaterial({
    transparent: true,
    depthTest,
    depthWrite: false,
    toneMapped: false,
    uniforms: { size: { value: BEAD }, opacity: { value: opacity } },
    vertexShader: /* glsl */ `
      attribute vec4 tint;
      uniform float size;
      varying vec4 vTint;
      varying float vSize;
      void main() {
        vTint = tint;
        vSize = size * (1.0 + 0.35 * min(tint.a, 1.5));
        gl_PointSize = vSize;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
        gl_Position.z -= 0.0014 * gl_Position.w;
      }`,
    fragmentShader: /* glsl */ `
      uniform float opacity;
      varying vec4 vTint;
      varying float vSize;
      void main() {
        float r = length(2.0 * gl_PointCoord - 1.0);
        float pixel = 2.0 / vSize;
        float disc = clamp((1.0 - r) / pixel, 0.0, 1.0);
        float core = clamp((0.6 - r) / pixel + 0.5, 0.0, 1.0);
        vec3 colour = mix(vTint.rgb, mix(vec3(1.0), vTint.rgb * 0.8, min(vTint.a, 1.0)), core);
        gl_FragColor = vec4(colour, disc * opacity);
      }`,
  });
}
