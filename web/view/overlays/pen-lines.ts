import {
  BufferAttribute,
  Color,
  Group,
  Matrix4,
  type OrthographicCamera,
  type PerspectiveCamera,
  Vector3,
} from 'three';
import type { Layer, LayerContext, LayerKind } from '../layer';
import type { ModelView } from '../model-view';
import { PALETTES, type Palette } from '../palette';
import type { SurfaceShade } from '../surface-shade';
import { ViewSpace } from '../view-space';
import { holdAt, linesNear } from './pen-picking';
import { penStrokes } from './pen-strokes';
import { NO_SEGMENTS, SegmentLines, type Segments } from './segments';
import type { PenDrawing, PenHit, PenHold, PenPart, PenPort } from './types';

/** Drawn units: at an outline the line lies on faces that already turn away, a little behind what is in sight. */
const LIFT = 0.02;
/** CSS pixels. */
const LIT = 3.5;
const HELD = 3;
const END = 11;
const RING = 1.5;
const RING_PIECES = 96;

type Rgb = readonly [number, number, number];

/** The model as paper, with the lines of a view on it. */
class PenLines implements Layer, PenPort {
  readonly group = new Group();
  readonly bare = true;
  readonly #lines = new SegmentLines({ hidden: 0, order: 12, ink: true, lift: LIFT });
  readonly #lit = new SegmentLines({ hidden: 0, order: 14, lift: 1.5 * LIFT });
  readonly #held = new SegmentLines({ hidden: 0.7, order: 16, lift: 1.5 * LIFT });
  readonly #ring = new SegmentLines({ hidden: 0.5, order: 15 });
  readonly #uniforms = {
    penPaper: { value: new Vector3() },
    penEdge: { value: new Vector3() },
    penTint: { value: new Vector3() },
  };
  readonly shade = paper(this.#uniforms);
  #palette: Palette = PALETTES.dark;
  #space = ViewSpace.identity;
  #model: ModelView | undefined;
  #drawing: PenDrawing | null = null;
  /** Of the drawing's points: where they are carried to, model space, and as they are drawn. */
  #carried: Float64Array | null = null;
  #places = new Float32Array();
  #line: number | null = null;
  #hold: PenHold | null = null;
  #weights: Float32Array | null = null;
  #camera: PerspectiveCamera | OrthographicCamera | undefined;
  #size: readonly [number, number] = [1, 1];
  /** A picture is being made, without what helps to work. */
  #kept = false;

  constructor(private readonly context: LayerContext) {
    for (const { group } of [this.#lines, this.#lit, this.#held, this.#ring]) this.group.add(group);
  }

  place(space: ViewSpace, model: ModelView | undefined): void {
    // The same surface with other places at rest keeps its lines; on another one they mean nothing.
    const other = model?.model.faceVertices !== this.#model?.model.faceVertices;
    this.#space = space;
    if (model !== this.#model) {
      this.#model = model;
      this.tint(this.#weights);
    }
    if (other) this.#drawing = null;
    this.#draw();
    this.#drawHold();
  }

  setPalette(palette: Palette): void {
    this.#palette = palette;
    const { penPaper, penEdge, penTint } = this.#uniforms;
    penPaper.value.set(...shown(palette.paper));
    penEdge.value.set(...shown(palette.paperEdge));
    penTint.value.set(...shown(palette.tints.blue));
    this.#draw();
    this.#drawHold();
  }

  resize(width: number, height: number, pixelRatio: number): void {
    this.#size = [width, height];
    for (const lines of [this.#lines, this.#lit, this.#held, this.#ring])
      lines.resize(width, height, pixelRatio);
  }

  setKept(kept: boolean): void {
    this.#kept = kept;
    for (const { group } of [this.#lit, this.#held, this.#ring]) group.visible = !kept;
    if (kept) return;
    this.#drawLit();
    this.#drawHold();
  }

  prepare(camera: PerspectiveCamera | OrthographicCamera): void {
    this.#camera = camera;
    this.#drawRing();
  }

  setDrawing(drawing: PenDrawing | null): void {
    this.#drawing = drawing;
    this.#carried = null;
    this.#line = null;
    this.#draw();
    this.context.redraw();
  }

  carry(positions: Float64Array | null): void {
    const drawing = this.#drawing;
    if (!drawing || (!positions && !this.#carried)) return;
    this.#carried = positions && carried(drawing, positions);
    this.#draw();
    this.context.redraw();
  }

  light(line: number | null): void {
    if (line === this.#line) return;
    this.#line = line;
    this.#drawLit();
    this.#point();
    this.context.redraw();
  }

  hold(hold: PenHold | null): void {
    this.#hold = hold;
    this.#drawHold();
    this.#point();
    this.context.redraw();
  }

  tint(weights: Float32Array | null): void {
    this.#weights = weights;
    const geometry = this.#model?.geometry;
    if (!geometry) return;
    const fits = weights !== null && 3 * weights.length === this.#model!.model.positions.length;
    if (fits) geometry.setAttribute('pull', new BufferAttribute(weights, 1));
    else geometry.deleteAttribute('pull');
    this.context.redraw();
  }

  pickLines(x: number, y: number): readonly PenHit[] {
    if (!this.#drawing || !this.#camera) return [];
    const points = this.#carried ?? this.#drawing.points;
    return linesNear({ ...this.#drawing, points }, this.#seen(this.#camera), x, y);
  }

  pickHold(x: number, y: number): PenPart | null {
    const hold = this.#hold;
    if (!hold || !this.#camera) return null;
    const { centre, radius } = hold.ring;
    const at = this.#space.toView(centre);
    const middle = this.context.onScreen(at);
    const right = new Vector3().setFromMatrixColumn(this.#camera.matrixWorld, 0);
    const rim = this.context.onScreen(at.addScaledVector(right, radius * this.#space.scale));
    const line = hold.line.map((point) => this.context.onScreen(this.#space.toView(point)));
    return holdAt(line, middle, Math.hypot(rim.x - middle.x, rim.y - middle.y), x, y);
  }

  dispose(): void {
    this.context.renderer.domElement.style.cursor = '';
    this.#model?.geometry.deleteAttribute('pull');
    for (const part of [this.#lines, this.#lit, this.#held, this.#ring]) part.dispose();
  }

  #point(): void {
    const cursor = this.#hold?.lit ? 'grab' : this.#line !== null ? 'pointer' : '';
    this.context.renderer.domElement.style.cursor = cursor;
  }

  #draw(): void {
    const drawing = this.#drawing;
    if (!drawing) {
      this.#lines.set(NO_SEGMENTS);
      this.#lit.set(NO_SEGMENTS);
      return;
    }
    const points = this.#carried ?? drawing.points;
    if (this.#places.length !== points.length) this.#places = new Float32Array(points.length);
    this.#space.place(points, this.#places);
    this.#lines.set(penStrokes(drawing, this.#places, shown(this.#palette.ink)));
    this.#drawLit();
  }

  #drawLit(): void {
    const { offsets, closed } = this.#drawing ?? {};
    const line = this.#line;
    if (!offsets || line === null || line + 1 >= offsets.length) {
      this.#lit.set(NO_SEGMENTS);
      return;
    }
    const places = this.#places.subarray(3 * offsets[line]!, 3 * offsets[line + 1]!);
    this.#lit.set(run(places, closed![line] === 1, shown(this.#palette.tints.blue), LIT));
  }

  #drawHold(): void {
    const hold = this.#hold;
    if (!hold) {
      this.#held.set(NO_SEGMENTS);
      this.#ring.set(NO_SEGMENTS);
      return;
    }
    const places = Float32Array.from(hold.line.flatMap((point) => [...this.#space.toView(point)]));
    const violet = shown(this.#palette.tints.violet);
    const line = run(places, false, violet, hold.lit === 'line' ? LIT + 1 : HELD);
    const ends = ['start', 'end'].flatMap((end) => {
      const at = end === 'start' ? places.subarray(0, 3) : places.subarray(-3);
      const width = hold.lit === end ? END + 3 : END;
      return [
        { at, look: [1, 1, 1, width + 3] },
        { at, look: [...violet, width] },
      ];
    });
    this.#held.set({
      ends: Float32Array.from([...line.ends, ...ends.flatMap(({ at }) => [...at, ...at])]),
      looks: Float32Array.from([...line.looks, ...ends.flatMap(({ look }) => look)]),
    });
    this.#drawRing();
  }

  /** A circle that faces the eye. */
  #drawRing(): void {
    if (!this.#hold || !this.#camera || this.#kept) return;
    const { ring, lit } = this.#hold;
    const centre = this.#space.toView(ring.centre);
    const radius = ring.radius * this.#space.scale;
    const { matrixWorld } = this.#camera;
    const right = new Vector3().setFromMatrixColumn(matrixWorld, 0);
    const up = new Vector3().setFromMatrixColumn(matrixWorld, 1);
    const places = new Float32Array(3 * RING_PIECES);
    for (let i = 0; i < RING_PIECES; i++) {
      const turn = (2 * Math.PI * i) / RING_PIECES;
      const at = centre
        .clone()
        .addScaledVector(right, radius * Math.cos(turn))
        .addScaledVector(up, radius * Math.sin(turn));
      places.set([at.x, at.y, at.z], 3 * i);
    }
    this.#ring.set(run(places, true, shown(this.#palette.tints.blue), lit === 'ring' ? 2 * RING : RING));
  }

  /** The drawing's points on the screen: CSS pixels, and the depth before the eye. */
  #seen(camera: PerspectiveCamera | OrthographicCamera): Float32Array {
    const e = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).elements;
    const v = camera.matrixWorldInverse.elements;
    const [width, height] = this.#size;
    const places = this.#places;
    const out = new Float32Array(places.length);
    for (let i = 0; i < places.length; i += 3) {
      const [x, y, z] = [places[i]!, places[i + 1]!, places[i + 2]!];
      const w = e[3]! * x + e[7]! * y + e[11]! * z + e[15]!;
      out[i] = ((1 + (e[0]! * x + e[4]! * y + e[8]! * z + e[12]!) / w) / 2) * width;
      out[i + 1] = ((1 - (e[1]! * x + e[5]! * y + e[9]! * z + e[13]!) / w) / 2) * height;
      out[i + 2] = -(v[2]! * x + v[6]! * y + v[10]! * z + v[14]!);
    }
    return out;
  }
}

export const PEN_LINES: LayerKind<PenPort> = {
  id: 'pen-lines',
  make: (context) => new PenLines(context),
};

/** Where the points of a drawing go with the surface. */
function carried({ corners, weights }: PenDrawing, positions: Float64Array): Float64Array {
  const out = new Float64Array(corners.length);
  for (let i = 0; i < corners.length; i += 3)
    for (let k = 0; k < 3; k++)
      for (let axis = 0; axis < 3; axis++)
        out[i + axis]! += weights[i + k]! * positions[3 * corners[i + k]! + axis]!;
  return out;
}

/** One line of even width. @param places  3 per point, drawn units */
function run(places: Float32Array, closed: boolean, colour: Rgb, width: number): Segments {
  const count = Math.max(0, places.length / 3 - (closed ? 0 : 1));
  const ends = new Float32Array(6 * count);
  const looks = new Float32Array(4 * count);
  for (let i = 0; i < count; i++) {
    const next = (3 * i + 3) % places.length;
    ends.set(places.subarray(3 * i, 3 * i + 3), 6 * i);
    ends.set(places.subarray(next, next + 3), 6 * i + 3);
    looks.set([...colour, width], 4 * i);
  }
  return { ends, looks };
}

/** As the screen shows it. */
const shown = (css: string): [number, number, number] =>
  new Color(css).convertLinearToSRGB().toArray() as [number, number, number];

/** Pale and flat; only towards its outlines, and where it looks down, a shade darker. */
const paper = (uniforms: SurfaceShade['uniforms']): SurfaceShade => ({
  id: 'paper',
  uniforms,
  vertexDeclarations: /* glsl */ `
attribute float pull;
varying float vPull;
`,
  vertexBody: 'vPull = pull;',
  declarations: /* glsl */ `
uniform vec3 penPaper;
uniform vec3 penEdge;
uniform vec3 penTint;
varying float vPull;
`,
  colour: '',
  light: '',
  finish: /* glsl */ `
{
  float facing = abs(dot(normalize(normal), normalize(vViewPosition)));
  float turned = 1.0 - smoothstep(0.0, 0.6, facing);
  float below = 0.35 * smoothstep(0.1, 1.0, -normal.y);
  gl_FragColor.rgb = mix(penPaper, penEdge, clamp(turned + below, 0.0, 1.0));
  gl_FragColor.rgb = mix(gl_FragColor.rgb, penTint, 0.42 * clamp(vPull, 0.0, 1.0));
}
`,
});
