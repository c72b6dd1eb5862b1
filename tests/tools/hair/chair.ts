// A head to try hair tools on: a ball of radius 100 about the origin, one CSS pixel a model unit, seen in
// parallel from the front (+z), or from the right side (+x).

import { newHairStep } from '../../../web/recipe/steps/hair';
import type { HairEdit, HairEditLabel, HairHost, HairRemark, HairScene } from '../../../web/tools/hair/host';
import { REACH } from '../../../web/tools/hair/measures';
import { curvesOf, mainPart, pointsOf, primitiveAt } from '../../../web/tools/hair/style';
import { nearestOn } from '../../../web/tools/stroke/polyline';
import { onScreen } from '../../../web/tools/stroke/stroke';
import {
  type SupportKind,
  SupportSurface,
  type Viewpoint,
  viewpointOf,
} from '../../../web/tools/stroke/support';
import type { Tool } from '../../../web/tools/tool';
import type { ControlHit } from '../../../web/view/overlays/types';
import type { CameraState, Hit, PointerSample, Vec3 } from '../../../web/view/types';

export const RADIUS = 100;
const MIDDLE = 200;

export const emptyHair = newHairStep('hair 1', 'ball');

export type XY = readonly [number, number];

/** The app's side of a gesture, and a hand that makes gestures. Screen places are relative to the ball's middle, y up. */
export class Chair implements HairHost {
  step: HairScene['step'];
  selected: number | null = null;
  mirror = false;
  kind: SupportKind = 'strip';
  side: 'front' | 'right' = 'front';
  previewed: HairEdit | null = null;
  readonly commits: HairEditLabel[] = [];
  readonly remarks: HairRemark[] = [];
  shown: Parameters<HairHost['showStroke']>[0] = null;
  aimed = true;
  #viewpoint: Viewpoint;

  constructor(step: Partial<HairScene['step']> = {}) {
    this.step = { ...emptyHair, ...step };
    this.#viewpoint = viewpointOf(this.camera);
  }

  get camera(): CameraState {
    const position: Vec3 = this.side === 'front' ? [0, 0, 1000] : [1000, 0, 0];
    return { position, target: [0, 0, 0], orthographic: true };
  }

  get view(): HairHost['view'] {
    return {
      camera: this.camera,
      pick: (x, y) => this.hit(x, y),
      pixelSize: () => 1,
      project: ([x, y, z]) => ({
        x: MIDDLE + (this.side === 'front' ? x : -z),
        y: MIDDLE - y,
        behind: false,
      }),
      pointOnScreenPlane: (x, y, [tx, , tz]) => {
        const [across, up] = [x - MIDDLE, MIDDLE - y];
        return this.side === 'front' ? [across, up, tz] : [tx, up, -across];
      },
    };
  }

  readonly curves: HairHost['curves'] = { pickLine: (x, y) => this.#pickLine(x, y) };

  scene(): HairScene {
    const { step, selected, mirror } = this;
    return { step, selected, mirror, height: 2 * RADIUS };
  }
  preview(edit: HairEdit): void {
    this.previewed = edit;
  }
  commit(label: HairEditLabel, { step, selected }: HairEdit): void {
    this.commits.push(label);
    this.previewed = null;
    this.step = step;
    this.selected = selected;
  }
  cancel(): void {
    this.previewed = null;
  }
  select(primitive: number | null): void {
    this.selected = primitive;
  }
  support(): SupportSurface | null {
    const primitive = primitiveAt(this.step, this.selected);
    if (!primitive) return null;
    const line = pointsOf(primitive, mainPart(primitive));
    return new SupportSurface(line, this.#viewpoint, this.kind, REACH * 2 * RADIUS);
  }
  rebuildSupport(): void {
    this.#viewpoint = viewpointOf(this.camera);
  }
  showStroke(stroke: Parameters<HairHost['showStroke']>[0]): void {
    this.shown = stroke;
  }
  say(remark: HairRemark): void {
    this.remarks.push(remark);
  }
  aim(onHead: boolean): void {
    this.aimed = onHead;
  }

  hit(x: number, y: number): Hit | null {
    const [across, up] = [x - MIDDLE, MIDDLE - y];
    const squared = RADIUS ** 2 - across ** 2 - up ** 2;
    if (squared < 0) return null;
    const near = Math.sqrt(squared);
    const point: Vec3 = this.side === 'front' ? [across, up, near] : [near, up, -across];
    const normal = point.map((c) => c / RADIUS) as unknown as Vec3;
    return { point, normal, triangle: 0, vertex: 0, distance: 1000 - near };
  }

  sample([x, y]: XY, how: Partial<PointerSample> = {}): PointerSample {
    const place = { x: MIDDLE + x, y: MIDDLE - y };
    const keys = { shift: false, alt: false, ctrl: false };
    const hit = this.hit(place.x, place.y);
    return { ...place, pressure: 0.5, pointerType: 'mouse', button: 0, ...keys, hit, ...how };
  }

  /** Press at the first place, draw straight from each to the next, release at the last. @returns whether the tool took it */
  stroke(tool: Tool, ...path: readonly XY[]): boolean {
    const samples = walk(path).map((place) => this.sample(place));
    if (!tool.down(samples[0]!)) return false;
    for (const sample of samples.slice(1)) tool.move([sample]);
    tool.up(samples.at(-1)!);
    return true;
  }

  #pickLine(x: number, y: number): ControlHit | null {
    let best: ControlHit | null = null;
    let least = 6;
    for (const { id, points } of curvesOf(this.step, this.selected)) {
      const found = nearestOn(onScreen(this.view, points), [x, y, 0]);
      if (!found || found.distance > least) continue;
      least = found.distance;
      const at = [found.segment, found.segment + 1].find((i) => {
        const [px, py] = onScreen(this.view, points)[i]!;
        return Math.hypot(px - x, py - y) < 4;
      });
      best = { id, segment: found.segment, point: at ?? null };
    }
    return best;
  }
}

/** Places every four pixels along a path. */
export function walk(path: readonly XY[]): XY[] {
  const out: XY[] = path.slice(0, 1);
  for (const [i, [bx, by]] of path.entries()) {
    if (i === 0) continue;
    const [ax, ay] = path[i - 1]!;
    const steps = Math.max(1, Math.ceil(Math.hypot(bx - ax, by - ay) / 4));
    for (let k = 1; k <= steps; k++) out.push([ax + ((bx - ax) * k) / steps, ay + ((by - ay) * k) / steps]);
  }
  return out;
}
