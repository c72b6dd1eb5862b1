// Small recipes of every step type with every field set, on the models of `models.ts`.

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const moved = (x: number, y: number, z: number) => [...IDENTITY.slice(0, 12), x, y, z, 1];

export const DEFORM = {
  lissom: 1,
  models: { m: { builtin: 'bar' } },
  steps: [
    {
      id: 'd',
      type: 'deform',
      model: 'm',
      roi: { ranges: [[0, 70]] },
      handles: [
        { kind: 'region', vertices: { ranges: [[0, 8]] }, matrix: IDENTITY, name: 'foot' },
        { kind: 'region', vertices: [63, 64, 65], matrix: moved(0, 0.2, 0.3) },
        { kind: 'point', vertices: [40], position: [0.5, 0.4, 0.3], hidden: true },
      ],
      method: 'implicit',
      options: { removeShear: true, scaleDetails: false, iterations: 2, coherenceRing: 1 },
    },
  ],
  outputs: [{ step: 'd', file: 'o.ply' }],
};

export const MERGE = {
  lissom: 1,
  models: { s: { builtin: 'wings' }, t: { builtin: 'block' } },
  steps: [
    {
      id: 'm',
      type: 'merge',
      source: 's',
      target: 't',
      mode: 'dependent',
      boundaries: [
        {
          source: ring(12),
          target: ring(15),
          keys: [
            [0, 0],
            [6, 7],
          ],
          sourceKeep: [],
          targetKeep: [],
        },
      ],
      transition: { sourceWidth: 0.5, targetWidth: 0.5, weight: 0.1 },
      roi: 'all',
      handles: [{ vertices: [60], matrix: moved(0, 0.1, 0), name: 'tip' }],
      pose: moved(0, 0.5, 0),
      smoothing: 1,
    },
  ],
  outputs: [{ step: 'm', file: 'o.obj' }],
};

export const HAIR = {
  lissom: 1,
  models: { h: { builtin: 'head-female' } },
  steps: [
    {
      id: 'hair',
      type: 'hair',
      model: 'h',
      scalp: { ranges: [[0, 180]] },
      grid: { resolution: 16 },
      streams: [
        {
          points: [
            [0, 0.12, 0],
            [0.05, 0.11, 0.03],
            [0.09, 0.02, 0.05],
          ],
          fade: true,
        },
      ],
      partings: [
        {
          points: [
            [0, 0.12, 0.02],
            [0, 0.1, 0.06],
          ],
          tilt: [10, -5],
          sigma: 1,
          height: 0.5,
        },
      ],
      ponytails: [
        {
          spine: [
            [0, 0.05, -0.12],
            [0, 0, -0.16],
            [0, -0.1, -0.17],
          ],
          section: [
            [-0.02, 0.05, -0.12],
            [0, 0.07, -0.12],
            [0.02, 0.05, -0.12],
            [0, 0.03, -0.12],
          ],
          profiles: [],
          tightness: 0.6,
        },
      ],
      strands: { count: 60, seed: 1, step: 0.8 },
      length: { max: 0.2, variation: 0.2, map: [{ vertices: [3, 4, 5], factor: 0.5 }] },
      volume: 0.02,
      detail: { clump: 0.4, curl: 0.3, curlLength: 0.02, frizz: 0.2, flyaways: 0.05 },
      material: { melanin: 0.5, redness: 0.3, colorVariation: 0.2, thickness: 1e-4, taper: 0.3 },
    },
  ],
  outputs: [{ step: 'hair', file: 'o.hair' }],
};

export const TRANSFER = {
  lissom: 1,
  models: { m: { builtin: 'bar' }, t: { builtin: 'block' } },
  steps: [
    DEFORM.steps[0],
    {
      id: 't1',
      type: 'transfer',
      model: 't',
      like: 'd',
      handles: [{ ranges: [[0, 11]] }, [48, 49, 50], [30]],
      strength: 0.8,
      keepStretch: true,
    },
  ],
  outputs: [{ step: 't1', file: 'o.ply' }],
};

const column = (x: number, bend = 0) => [0, 1, 2, 3].map((k) => [x + bend * k * k, 0.2 + 0.2 * k, 0.05]);

export const CURVES = {
  lissom: 1,
  models: { m: { builtin: 'bar' } },
  steps: [
    {
      id: 'c',
      type: 'curves',
      model: 'm',
      curves: [
        {
          id: 'trunk',
          kind: 'skeleton',
          rest: column(0.05),
          posed: column(0.05, 0.04),
          base: [0, 0, 0.1, 0.995],
          twist: [0, 10, 20, 30],
          scale: [
            [1, 1],
            [1, 1.2],
            [1.1, 1.2],
            [1, 1],
          ],
          rigid: [1],
          region: { ranges: [[4, 40]] },
          anchor: 'start',
        },
        { id: 'branch', kind: 'surface', rest: column(0.4).slice(0, 2), twist: [0, 90] },
        {
          id: 'brow',
          kind: 'contour',
          rest: column(0.7),
          posed: column(0.72),
          reach: 0.2,
          held: [column(0.75), column(0.6).slice(1)],
        },
      ],
      links: [{ child: 'branch', parent: 'trunk', at: 0.6 }],
      options: { blending: 'ownership', encoding: 'kernel', guard: 'symmetric' },
      poses: [{ name: 'bent', time: 1, curves: [{ id: 'trunk', posed: column(0, 0.1) }] }],
    },
  ],
  outputs: [{ step: 'c', file: 'o.ply' }],
};

export const EXAMPLES: readonly object[] = [DEFORM, MERGE, HAIR, TRANSFER, CURVES];

function ring(count: number): number[] {
  return Array.from({ length: count }, (_, i) => i);
}

/** Of two balls cut differently: see `tests/kernel/balls.ts`. */
export const MATCH = {
  lissom: 1,
  models: { m: { builtin: 'bar' }, t: { builtin: 'block' } },
  steps: [
    {
      id: 'm1',
      type: 'match',
      models: ['m', 't'],
      markers: [
        [0, 0],
        [30, { face: 5, at: [0.2, 0.3, 0.5] }],
        [60, 70],
        [{ point: [0.1, -0.9, 0] }, { point: [0, -0.9, 0.1] }],
      ],
      edgeLength: 0.5,
      adapt: 0.2,
      sharpAngle: 60,
      curves: [
        [
          [3, 4, 5],
          [4, 5],
        ],
      ],
      mask: [[7, 8], { ranges: [[20, 24]] }],
      start: 'automatic',
    },
  ],
  outputs: [{ step: 'm1/m', file: 'o.ply' }],
};
