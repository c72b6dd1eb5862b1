// A table to try tools on: a flat sheet of 21 × 21 vertices, one CSS pixel a model unit, seen from above.

import type { DeformStep } from '../../web/recipe/recipe';
import type { Paint } from '../../web/tools/brush-stroke';
import type { DeformEdit, DeformHost, DeformScene, EditLabel } from '../../web/tools/deform/host';
import { MeshGraph } from '../../web/tools/mesh-graph';
import type { Tool } from '../../web/tools/tool';
import type { Hit, PointerSample } from '../../web/view/types';

export const SIDE = 21;
export const at = (x: number, y: number): number => y * SIDE + x;

export function sheet() {
  const positions = new Float64Array(3 * SIDE * SIDE);
  const triangles: number[] = [];
  for (let y = 0; y < SIDE; y++)
    for (let x = 0; x < SIDE; x++) {
      positions.set([x, y, 0], 3 * at(x, y));
      if (x + 1 < SIDE && y + 1 < SIDE)
        triangles.push(at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y), at(x + 1, y + 1), at(x, y + 1));
    }
  const welded = Int32Array.from({ length: SIDE * SIDE }, (_, i) => i);
  return { positions, triangles: Uint32Array.from(triangles), welded };
}

export const emptyStep: DeformStep = {
  id: 'deform-1',
  type: 'deform',
  model: 'sheet',
  roi: 'all',
  handles: [],
  method: 'implicit',
  options: { removeShear: true, scaleDetails: false, iterations: 1, coherenceRing: 1 },
};

/** The app's side of a gesture, and a hand that makes gestures. */
export class Table implements DeformHost {
  step: DeformStep;
  selected: number | null = null;
  previewed: DeformEdit | null = null;
  painted: Paint | null = null;
  readonly commits: EditLabel[] = [];
  erase = false;
  radius = 1.5;
  rest = sheet().positions;
  posed = this.rest;
  brushShown: { radius: number; erase: boolean } | null = null;
  mirrored: DeformScene['mirrored'] = (set) => set;
  readonly graph = new MeshGraph(sheet());

  constructor(step: Partial<DeformStep> = {}) {
    this.step = { ...emptyStep, ...step };
  }

  readonly view = {
    pick: (x: number, y: number): Hit | null => this.hit(x, y),
    verticesWithin: ({ point }: Hit, radius: number): Uint32Array =>
      Uint32Array.from({ length: SIDE * SIDE }, (_, i) => i).filter(
        (i) => Math.hypot((i % SIDE) - point[0], Math.floor(i / SIDE) - point[1]) <= radius,
      ),
    pointOnScreenPlane: (x: number, y: number, through: readonly [number, number, number]) =>
      [x, y, through[2]] as const,
    pixelSize: () => 1,
    setBrush: (brush: { hit: Hit; radius: number; erase: boolean } | null) => {
      this.brushShown = brush;
    },
  };

  readonly markers = {
    pickMarker: (x: number, y: number): string | null => {
      const index = this.step.handles.findIndex(
        (h) => h.kind === 'point' && Math.hypot(h.position[0] - x, h.position[1] - y) < 0.5,
      );
      return index < 0 ? null : `handle:${index}`;
    },
  };

  scene(): DeformScene {
    const { step, selected, rest, posed, graph } = this;
    return { step, selected, rest, posed, graph, mirrored: (set) => this.mirrored(set) };
  }
  brush = () => ({ radius: this.radius, erase: this.erase });
  newName = (step: DeformStep) => `Handle ${step.handles.length + 1}`;
  preview(edit: DeformEdit): void {
    this.previewed = edit;
  }
  commit(label: EditLabel, { step, selected }: DeformEdit): void {
    this.commits.push(label);
    this.previewed = null;
    this.step = step;
    this.selected = selected;
  }
  cancel(): void {
    this.previewed = null;
  }
  select(handle: number | null): void {
    this.selected = handle;
  }
  showPaint(paint: Paint | null): void {
    this.painted = paint;
  }

  hit(x: number, y: number): Hit | null {
    if (x < 0 || y < 0 || x > SIDE - 1 || y > SIDE - 1) return null;
    const vertex = at(Math.round(x), Math.round(y));
    return { point: [x, y, 0], normal: [0, 0, 1], triangle: 0, vertex, distance: 1 };
  }

  sample(x: number, y: number, how: Partial<PointerSample> = {}): PointerSample {
    const hit = this.hit(x, y);
    const keys = { shift: false, alt: false, ctrl: false };
    return { x, y, pressure: 0.5, pointerType: 'mouse', button: 0, ...keys, hit, ...how };
  }

  /** Press at the first place, move over the others, release at the last. @returns whether the tool took it */
  stroke(
    tool: Tool,
    path: readonly (readonly [number, number])[],
    how: Partial<PointerSample> = {},
  ): boolean {
    const samples = path.map(([x, y]) => this.sample(x, y, how));
    if (!tool.down(samples[0]!)) return false;
    for (const sample of samples.slice(1)) tool.move([sample]);
    tool.up(samples.at(-1)!);
    return true;
  }

  click(tool: Tool, x: number, y: number, how: Partial<PointerSample> = {}): boolean {
    return this.stroke(tool, [[x, y]], how);
  }
}
