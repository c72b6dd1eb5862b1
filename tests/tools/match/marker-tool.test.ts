// The tools that mark models, on a flat square of 200 × 200 CSS pixels, one a model unit, seen from above.

import { describe, expect, test } from 'vitest';
import { type MarkerPlace, type MatchStep, newMatchStep } from '../../../web/recipe/steps/match';
import { EdgeGraph } from '../../../web/tools/edge-graph';
import { CurveTool } from '../../../web/tools/match/curve-tool';
import { withPlace } from '../../../web/tools/match/edits';
import type { MarkVerb, MatchHost, MatchScene } from '../../../web/tools/match/host';
import { MarkerTool } from '../../../web/tools/match/marker-tool';
import { pointOf, type Spot, type Surface, spotAt } from '../../../web/tools/match/places';
import { MeshGraph } from '../../../web/tools/mesh-graph';
import type { Tool } from '../../../web/tools/tool';
import type { Hit, PointerSample, Vec3 } from '../../../web/view/types';

const SIZE = 200;
const SQUARE: Surface = {
  model: {
    name: 'square',
    positions: Float64Array.of(0, 0, 0, SIZE, 0, 0, SIZE, SIZE, 0, 0, SIZE, 0),
    faceOffsets: Uint32Array.of(0, 4),
    faceVertices: Uint32Array.of(0, 1, 2, 3),
  },
  opened: { triangles: Uint32Array.of(0, 1, 2, 0, 2, 3), faceOfTriangle: Uint32Array.of(0, 0) },
};

function hitAt(x: number, y: number): Hit | null {
  if (x < 0 || y < 0 || x > SIZE || y > SIZE) return null;
  return { point: [x, y, 0], normal: [0, 0, 1], triangle: x > y ? 0 : 1, vertex: 0, distance: 1000 };
}

const sample = (x: number, y: number): PointerSample => ({
  x,
  y,
  pressure: 0.5,
  pointerType: 'mouse',
  button: 0,
  shift: false,
  alt: false,
  ctrl: false,
  hit: hitAt(x, y),
});

/** The second of two models. */
class Seat implements MatchHost {
  step: MatchStep;
  marker: number | null = null;
  ghost: Spot | null = null;
  readonly log: unknown[] = [];
  line: readonly Vec3[] | null = null;

  constructor(markers: MatchStep['markers'] = []) {
    this.step = { ...newMatchStep('m', ['a', 'b']), markers };
  }

  readonly view = {
    pick: hitAt,
    project: ([x, y]: Vec3) => ({ x, y, behind: false }),
    camera: { position: [0, 0, 1000] as Vec3, target: [0, 0, 0] as Vec3, orthographic: true },
    verticesWithin: () => new Uint32Array(),
    pixelSize: () => 1,
    setBrush: () => {},
    pointOnScreenPlane: (x: number, y: number): Vec3 => [x, y, 0],
  };

  scene(): MatchScene {
    const { step, marker, ghost } = this;
    const graph = new MeshGraph({ triangles: SQUARE.opened.triangles, welded: Int32Array.of(0, 1, 2, 3) });
    return {
      step,
      at: 1,
      surface: SQUARE,
      marker,
      curve: null,
      sharp: [],
      sharpRow: null,
      edges: () =>
        new EdgeGraph({
          ...SQUARE.opened,
          positions: SQUARE.model.positions,
          welded: Int32Array.of(0, 1, 2, 3),
        }),
      ghost,
      ignored: new Uint32Array(),
      graph,
      mirrored: (set) => set,
    };
  }

  brush = () => ({ radius: 10, erase: false });
  showPaint(): void {}
  previewMarker(marker: number): void {
    this.log.push(['preview', marker]);
  }
  commitMarker(verb: MarkVerb, marker: number, { place, point }: Spot): void {
    this.log.push([verb, marker, point.map(Math.round)]);
    this.step = withPlace(this.step, marker, 1, place);
  }
  pickMarker(marker: number): void {
    this.log.push(['pick', marker]);
    this.marker = marker;
  }
  showLine(line: readonly Vec3[] | null): void {
    this.line = line;
  }
  commitCurve(curve: number, row: MarkerPlace[]): void {
    this.log.push(['curve', curve, row.map((place) => pointOf(SQUARE, place)!.map(Math.round))]);
  }
  commitSharp(): void {}
  commitMask(): void {}
  tooShort(): void {
    this.log.push('short');
  }
  cancel(): void {
    this.log.push('cancel');
  }

  /** What was done, previews left out. */
  get done(): unknown[] {
    return this.log.filter((each) => !Array.isArray(each) || each[0] !== 'preview');
  }
}

function gesture(tool: Tool, ...[first, ...rest]: [number, number][]): boolean {
  const taken = tool.down(sample(...first!));
  if (!taken) return false;
  for (const place of rest) tool.move([sample(...place)]);
  tool.up(sample(...(rest.at(-1) ?? first!)));
  return true;
}

describe('markers', () => {
  test('a press sets one where it is let go', () => {
    const seat = new Seat([[7, null]]);
    seat.marker = 0;
    expect(gesture(new MarkerTool(seat, true), [50, 60], [90, 80])).toBe(true);
    expect(seat.done).toEqual([['place', 0, [90, 80, 0]]]);
    expect(seat.log[0]).toEqual(['preview', 0]);
  });

  test('one that is there is taken hold of, and stays where it was only clicked', () => {
    const seat = new Seat([[7, spotAt(SQUARE, hitAt(100, 40)!).place]]);
    expect(gesture(new MarkerTool(seat, true), [104, 44])).toBe(true);
    expect(seat.done).toEqual([['pick', 0], 'cancel']);
    gesture(new MarkerTool(seat, true), [104, 44], [150, 40]);
    expect(seat.done.at(-1)).toEqual(['move', 0, [150, 40, 0]]);
  });

  test('a press on the suggestion takes it as it is', () => {
    const seat = new Seat([[7, null]]);
    seat.marker = 0;
    seat.ghost = spotAt(SQUARE, hitAt(120, 30)!);
    gesture(new MarkerTool(seat, true), [126, 34]);
    expect(seat.done).toEqual([['place', 0, [120, 30, 0]]]);
  });

  test('where the hand is to turn the view, the camera has what is no marker', () => {
    const seat = new Seat([[7, spotAt(SQUARE, hitAt(100, 40)!).place]]);
    const hand = new MarkerTool(seat, false);
    expect(gesture(hand, [20, 150])).toBe(false);
    expect(gesture(hand, [100, 40])).toBe(true);
    expect(seat.done).toEqual([['pick', 0], 'cancel']);
  });

  test('beside the model nothing is set; a cancelled press leaves no trace', () => {
    const seat = new Seat();
    const tool = new MarkerTool(seat, true);
    expect(gesture(tool, [300, 40])).toBe(false);
    tool.down(sample(40, 40));
    tool.cancel();
    expect(seat.done).toEqual(['cancel']);
  });
});

describe('lines', () => {
  test('one is kept as places along it, from end to end', () => {
    const seat = new Seat();
    gesture(new CurveTool(seat), [20, 100], [60, 100], [100, 100], [160, 100]);
    const [[, curve, row]] = seat.done as [[string, number, number[][]]];
    expect(curve).toBe(0);
    expect(row[0]).toEqual([20, 100, 0]);
    expect(row.at(-1)).toEqual([160, 100, 0]);
    expect(row.length).toBeGreaterThan(10);
    for (const [, y] of row) expect(y).toBe(100);
    expect(seat.line).toBeNull();
  });

  test('what is no longer than a click is none', () => {
    const seat = new Seat();
    gesture(new CurveTool(seat), [20, 100], [24, 100]);
    expect(seat.done).toEqual(['short']);
  });
});
