import { BufferAttribute, BufferGeometry, Color, Group, Points, ShaderMaterial } from 'three';
import type { Layer, LayerContext, LayerKind } from '../layer';
import { ViewSpace } from '../view-space';
import { SegmentLines } from './segments';
import type { Curve, CurveHit, CurvesPort } from './types';

const COLOURS: Readonly<Record<Curve['tint'], string>> = {
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

/** Curves over everything: thin lines with small beads, paler where something hides them. */
class CurveOverlay implements Layer, CurvesPort {
  readonly group = new Group();
  readonly aid = true;
  readonly #lines = new SegmentLines({ hidden: 0.35, order: 30 });
  readonly #beadGeometry = new BufferGeometry();
  readonly #front = beads(1, true);
  readonly #behind = beads(0.35, false);
  #curves: readonly Curve[] = [];
  #space = ViewSpace.identity;

  constructor(private readonly context: LayerContext) {
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
    for (const material of [this.#front, this.#behind]) material.uniforms.size!.value = BEAD * pixelRatio;
  }

  setCurves(curves: readonly Curve[]): void {
    this.#curves = curves;
    this.#draw();
    this.context.redraw();
  }

  pickCurve(x: number, y: number): CurveHit | null {
    return pickCurve(this.#curves, x, y, (point) => this.context.onScreen(this.#space.toView(point)));
  }

  dispose(): void {
    for (const part of [this.#lines, this.#beadGeometry, this.#front, this.#behind]) part.dispose();
  }

  #draw(): void {
    const curves = this.#curves;
    const pieces = curves.reduce((sum, { points }) => sum + Math.max(0, points.length - 1), 0);
    const ends = new Float32Array(6 * pieces);
    const looks = new Float32Array(4 * pieces);
    const places: number[] = [];
    const tints: number[] = [];
    let piece = 0;
    for (const { points, tint: name, selected, plain } of curves) {
      const tint = shown(name, selected);
      const drawn = points.map((point) => this.#space.toView(point));
      drawn.forEach((place, i) => {
        if (!plain) {
          places.push(...place);
          tints.push(...tint, Number(selected));
        }
        const next = drawn[i + 1];
        if (!next) return;
        ends.set([...place, ...next], 6 * piece);
        looks.set([...tint, selected ? 1.4 * WIDTH : WIDTH], 4 * piece++);
      });
    }
    this.#lines.set({ ends, looks });
    this.#beadGeometry.dispose();
    this.#beadGeometry.setAttribute('position', new BufferAttribute(Float32Array.from(places), 3));
    this.#beadGeometry.setAttribute('tint', new BufferAttribute(Float32Array.from(tints), 4));
    this.group.visible = curves.length > 0;
  }
}

export const CURVES: LayerKind<CurvesPort> = {
  id: 'curves',
  make: (context) => new CurveOverlay(context),
};

/** The nearest control point in reach, else the nearest line in reach. */
export function pickCurve(
  curves: readonly Curve[],
  x: number,
  y: number,
  project: (point: Curve['points'][number]) => { x: number; y: number; z: number },
): CurveHit | null {
  let point: CurveHit | null = null;
  let line: CurveHit | null = null;
  let nearestPoint = POINT_REACH;
  let nearestLine = LINE_REACH;
  for (const { id, plain, points } of curves) {
    if (plain) continue;
    const seen = points.map(project);
    seen.forEach((a, i) => {
      if (a.z < 0) return;
      const gap = Math.hypot(a.x - x, a.y - y);
      if (gap <= nearestPoint) {
        nearestPoint = gap;
        point = { id, point: i, segment: Math.max(0, Math.min(i, points.length - 2)) };
      }
      const b = seen[i + 1];
      if (!b || b.z < 0) return;
      const [dx, dy] = [b.x - a.x, b.y - a.y];
      const t = Math.min(1, Math.max(0, ((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy || 1)));
      const off = Math.hypot(a.x + t * dx - x, a.y + t * dy - y);
      if (off > nearestLine) return;
      nearestLine = off;
      line = { id, point: null, segment: i };
    });
  }
  return point ?? line;
}

/** As the screen shows it. */
function shown(tint: Curve['tint'], selected: boolean): [number, number, number] {
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
        vSize = size * (1.0 + 0.35 * tint.a);
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
        vec3 colour = mix(vTint.rgb, mix(vec3(1.0), vTint.rgb * 0.8, vTint.a), core);
        gl_FragColor = vec4(colour, disc * opacity);
      }`,
  });
}
