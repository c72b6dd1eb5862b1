// How each call of the kernel is ended when nobody waits for it any more: by Esc, Ctrl-C, a timeout, a newer request.
// In slices of 25 ms, at the next of which it stops; or, a call that is one piece, together with its worker (in Node: its
// thread), which the client replaces 150 ms after the cancellation. So none goes on for longer than that.

import { expect, test } from 'vitest';
import type { KernelModule } from '../../wasm/bindings/kernel';
import type { Method } from '../../web/kernel/contract';
import { createHandlers } from '../../web/kernel/handlers/all';

type Ending = 'in slices' | 'with its worker';

/** Beside each its longest piece, in Node on a busy machine of two cores, for models of 160,000 vertices and a grid of 96. */
const ENDINGS: Readonly<Record<Method, Ending>> = {
  openModel: 'with its worker', // 2.2 s
  measure: 'with its worker', // 0.3 s
  release: 'with its worker', // 0
  prepareDeform: 'in slices', // the first one, which assembles and orders, 17 s: that one ends with its worker
  deform: 'with its worker', // 0.8 s a round, up to 100 of them
  estimateIsolines: 'with its worker', // 0
  prepareIsolineModel: 'in slices', // the first one, which welds and simplifies: as above
  prepareIsolines: 'in slices', // 1 s
  dragIsolines: 'with its worker', // 0.02 s
  poseIsolines: 'in slices', // the first one of a full pass, which assembles: as above
  isolineFields: 'with its worker', // 0.1 s
  isolineField: 'with its worker', // 0.1 s
  isolineCurves: 'with its worker', // 0.1 s
  prepareTransfer: 'in slices', // 1 s
  transfer: 'with its worker', // 0.3 s a pose
  match: 'in slices', // 1 s, a pass over edges or a step that is guarded
  carryPlaces: 'with its worker', // 0.2 s
  guessPlace: 'with its worker', // 0.3 s
  sharpEdges: 'with its worker',
  prepareBlend: 'in slices', // a part a slice
  blend: 'with its worker', // 0.1 s, of many measures 2 s
  prepareDress: 'in slices', // 2 s, the map of space
  dress: 'with its worker', // 1 s
  prepareTransferThrough: 'in slices', // 1 s, the factor of a skin
  transferThrough: 'with its worker', // 0.2 s
  placesOn: 'with its worker', // 0.3 s
  prepareMerge: 'in slices', // the first one, which cuts, refines, assembles and orders, 12 s: as above
  merge: 'with its worker', // 8 s
  mapRegions: 'with its worker', // 50 s for regions of 120,000 vertices
  loopsAround: 'with its worker', // 0.2 s
  prepareCurves: 'in slices', // a region a slice; where curves are linked the last, which factors, 3 s: as above
  poseCurves: 'with its worker', // 0.1 s
  curveAttributes: 'with its worker', // 0.1 s
  curveTable: 'with its worker', // 0.02 s
  curveNormals: 'with its worker', // 0.3 s
  curveDragLimit: 'with its worker', // 0.2 s
  curveParents: 'with its worker', // 0.02 s
  reachCurve: 'with its worker', // 0
  selfIntersections: 'with its worker', // 1 s
  openHair: 'in slices', // the first one, which measures the head, 0.7 s: as above
  styleHair: 'with its worker', // 4.5 s
  growHair: 'in slices', // 0.2 s
  hairField: 'with its worker', // 0.1 s
  hairConstraints: 'with its worker', // 0
  prepareSketch: 'with its worker', // 0.3 s
  sketchCurve: 'with its worker', // 0.1 s
  curveRegion: 'with its worker', // 0.2 s
  proposeCurves: 'with its worker', // 1 s
  lineWeights: 'with its worker', // 0.5 s
  prepareContours: 'in slices', // the first one, which numbers edges: 0.3 s
  contourLines: 'in slices', // 0.05 s
};

test('what is said to go on in slices takes a job, and nothing else does', () => {
  const handlers = createHandlers({} as KernelModule, 0);
  const found = Object.fromEntries(
    Object.entries(handlers).map(([method, { length }]) => [
      method,
      length > 1 ? 'in slices' : 'with its worker',
    ]),
  );
  expect(found).toEqual(ENDINGS);
});
