// Draws the two plane maps, and tells which handle of the part's map is under a plane point.

import type { MapPlacement, PlaneMap, RegionMaps } from '../../kernel/contract/merge';
import { type PlacementHandle, type PlanePoint, placed } from '../../tools/merge/placement';

/** The square of the plane that is shown. */
export interface MapFrame {
  readonly centre: PlanePoint;
  /** CSS pixels a plane unit. */
  readonly unit: number;
  readonly size: number;
}

/** Map space: the maps' areas are π, so the part's own circle has radius 1. */
const RING = 1.15;
const KNOB = 7;
/** The target fills this part of the picture: the part may reach beyond it. */
const FILLED = 0.76;

export function frameOf({ target }: RegionMaps, size: number): MapFrame {
  const reach = target.points.reduce((most, x) => Math.max(most, Math.abs(x)), 1);
  return { centre: [0, 0], unit: (FILLED * size) / (2 * reach), size };
}

export const toPlane = ({ centre, unit, size }: MapFrame, x: number, y: number): PlanePoint => [
  centre[0] + (x - size / 2) / unit,
  centre[1] - (y - size / 2) / unit,
];

const toScreen = ({ centre, unit, size }: MapFrame, [x, y]: PlanePoint): PlanePoint => [
  size / 2 + (x - centre[0]) * unit,
  size / 2 - (y - centre[1]) * unit,
];

const knobs = (placement: MapPlacement): Readonly<Record<'turn' | 'scale', PlanePoint>> => ({
  turn: placed(placement, [0, RING]),
  scale: placed(placement, [RING * Math.SQRT1_2, -RING * Math.SQRT1_2]),
});

/** Knobs win over the map itself, which is moved. */
export function handleAt(frame: MapFrame, placement: MapPlacement, at: PlanePoint): PlacementHandle | null {
  const near = ([x, y]: PlanePoint) => Math.hypot(x - at[0], y - at[1]) * frame.unit <= 2 * KNOB;
  const { turn, scale } = knobs(placement);
  if (near(turn)) return 'turn';
  if (near(scale)) return 'scale';
  const { shift } = placement;
  return Math.hypot(at[0] - shift[0], at[1] - shift[1]) <= RING * placement.scale ? 'move' : null;
}

export function drawMaps(
  canvas: HTMLCanvasElement,
  size: number,
  maps: RegionMaps,
  placement: MapPlacement,
): void {
  const ratio = Math.min(2, window.devicePixelRatio || 1);
  canvas.width = size * ratio;
  canvas.height = size * ratio;
  const context = canvas.getContext('2d');
  if (!context) return;
  context.scale(ratio, ratio);
  const style = getComputedStyle(canvas);
  const colour = (name: string) => style.getPropertyValue(`--${name}`);
  const frame = frameOf(maps, size);
  drawMap(context, maps.target, colour('target'), (point) => toScreen(frame, point));
  drawMap(context, maps.source, colour('source'), (point) => toScreen(frame, placed(placement, point)));
  drawHandles(context, frame, placement, colour('source'), colour('panel'));
}

function drawMap(
  context: CanvasRenderingContext2D,
  { points, triangles }: PlaneMap,
  colour: string,
  place: (point: PlanePoint) => PlanePoint,
): void {
  const path = new Path2D();
  for (let t = 0; t < triangles.length; t += 3) {
    for (let k = 0; k < 3; k++) {
      const v = 2 * triangles[t + k]!;
      const [x, y] = place([points[v]!, points[v + 1]!]);
      if (k === 0) path.moveTo(x, y);
      else path.lineTo(x, y);
    }
    path.closePath();
  }
  context.fillStyle = colour;
  context.strokeStyle = colour;
  context.globalAlpha = 0.28;
  context.fill(path);
  context.globalAlpha = 0.4;
  context.lineWidth = 0.6;
  context.stroke(path);
  context.globalAlpha = 1;
}

function drawHandles(
  context: CanvasRenderingContext2D,
  frame: MapFrame,
  placement: MapPlacement,
  colour: string,
  ground: string,
): void {
  const [cx, cy] = toScreen(frame, placement.shift);
  const { turn, scale } = knobs(placement);
  context.strokeStyle = colour;
  context.fillStyle = ground;
  context.lineWidth = 1.5;
  context.beginPath();
  context.arc(cx, cy, RING * placement.scale * frame.unit, 0, 2 * Math.PI);
  context.stroke();
  const [tx, ty] = toScreen(frame, turn);
  context.beginPath();
  context.arc(tx, ty, KNOB, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
  const [sx, sy] = toScreen(frame, scale);
  context.beginPath();
  context.rect(sx - KNOB + 1, sy - KNOB + 1, 2 * KNOB - 2, 2 * KNOB - 2);
  context.fill();
  context.stroke();
}
