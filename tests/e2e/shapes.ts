// Small models as OBJ text: quads, in an order nobody would choose twice.

import { IDENTITY } from '../../web/core/affine';

/** A closed bar of `length` × `width` × `width` cells along x, all faces quads. */
export function barObj(length: number, width: number): string {
  const index = new Map<string, number>();
  const lines: string[] = [];
  const vertex = (x: number, y: number, z: number): number => {
    const key = `${x},${y},${z}`;
    let number = index.get(key);
    if (number === undefined) {
      number = index.size + 1;
      index.set(key, number);
      lines.push(`v ${x} ${y} ${z}`);
    }
    return number;
  };
  const faces: string[] = [];
  const size = [length, width, width] as const;
  for (const axis of [0, 1, 2] as const) {
    const [u, v] = [(axis + 1) % 3, (axis + 2) % 3] as [0 | 1 | 2, 0 | 1 | 2];
    for (const side of [0, size[axis]])
      for (let i = 0; i < size[u]; i++)
        for (let j = 0; j < size[v]; j++) {
          const corner = (du: number, dv: number): number => {
            const at: [number, number, number] = [0, 0, 0];
            [at[axis], at[u], at[v]] = [side, i + du, j + dv];
            return vertex(...at);
          };
          const ring = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
          faces.push(`f ${(side === 0 ? ring.reverse() : ring).join(' ')}`);
        }
  }
  return `${[...lines, 'g bar', ...faces].join('\n')}\n`;
}

/** A wavy open sheet of `n` × `n` quads: many vertices in little text. */
export function sheetObj(n: number): string {
  const lines: string[] = [];
  for (let j = 0; j <= n; j++)
    for (let i = 0; i <= n; i++)
      lines.push(`v ${i} ${(4 * Math.sin(i / 9) * Math.cos(j / 11)).toFixed(4)} ${j}`);
  for (let j = 0; j < n; j++)
    for (let i = 0; i < n; i++) {
      const a = j * (n + 1) + i + 1;
      lines.push(`f ${a} ${a + n + 1} ${a + n + 2} ${a + 1}`);
    }
  return `${lines.join('\n')}\n`;
}

/** The same rolled up, but for a slit: its isolines from side to side are rings. */
export function rolledObj(n: number): string {
  const radius = n / 6;
  return sheetObj(n).replace(/^v (\S+) (\S+) (\S+)$/gm, (_, x, y, z) => {
    const [angle, r] = [(6 * Number(z)) / n, radius + Number(y)];
    return `v ${x} ${(r * Math.cos(angle)).toFixed(4)} ${(r * Math.sin(angle)).toFixed(4)}`;
  });
}

/** A recipe of such a sheet, sheet.obj, held along both sides. @param width  of the strips, in vertices */
export function sheetRecipe(n: number, width: number, step: object): string {
  const strip = (name: string, from: number) => ({
    kind: 'region',
    name,
    vertices: Array.from(
      { length: width * (n + 1) },
      (_, i) => Math.floor(i / width) * (n + 1) + from + (i % width),
    ),
    matrix: IDENTITY,
  });
  const handles = [strip('Left', 0), strip('Right', n + 1 - width)];
  return JSON.stringify({
    lissom: 1,
    models: { sheet: { file: 'sheet.obj' } },
    steps: [{ id: 'deform 1', type: 'deform', model: 'sheet', handles, ...step }],
  });
}

const LENGTH = 16;
const WIDTH = 4;
export const BAR = barObj(LENGTH, WIDTH);

const vertices = BAR.split('\n')
  .filter((line) => line.startsWith('v '))
  .map((line) => line.split(' ').slice(1).map(Number));
/** The bar's vertices for which `inside(x, y, z)` holds. */
export const ofBar = (inside: (x: number, y: number, z: number) => boolean): number[] =>
  vertices.flatMap(([x, y, z], v) => (inside(x!, y!, z!) ? [v] : []));

const rest = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
/** The bar held at both ends; what lies beyond x = 3 may move. */
export const BAR_RECIPE = JSON.stringify({
  lissom: 1,
  models: { bar: { file: 'bar.obj' } },
  steps: [
    {
      id: 'deform 1',
      type: 'deform',
      model: 'bar',
      roi: ofBar((x) => x > 3),
      handles: [
        { kind: 'region', name: 'Foot', vertices: ofBar((x) => x < 2), matrix: rest },
        { kind: 'region', name: 'Tip', vertices: ofBar((x) => x > LENGTH - 2), matrix: rest },
      ],
      method: 'implicit',
      options: { removeShear: true, scaleDetails: false, iterations: 1, coherenceRing: 1 },
    },
  ],
  outputs: [],
});

/** A trunk that stands up, with an arm to either side: the closed surface of a heap of unit cubes, all faces quads. */
export function limbsObj(): string {
  const cells = new Set<string>();
  const fill = (x0: number, x1: number, y0: number, y1: number) => {
    for (let x = x0; x < x1; x++)
      for (let y = y0; y < y1; y++) for (let z = 0; z < 3; z++) cells.add(`${x},${y},${z}`);
  };
  fill(0, 3, 0, 20);
  fill(3, 15, 16, 19);
  fill(-12, 0, 16, 19);
  const index = new Map<string, number>();
  const vertex = (at: readonly number[]): number => {
    const key = at.join(' ');
    if (!index.has(key)) index.set(key, index.size + 1);
    return index.get(key)!;
  };
  const faces: string[] = [];
  for (const cell of cells) {
    const at = cell.split(',').map(Number);
    for (const axis of [0, 1, 2])
      for (const side of [0, 1]) {
        const beside = at.map((x, k) => (k === axis ? x + 2 * side - 1 : x));
        if (cells.has(beside.join())) continue;
        const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
        const corner = (du: number, dv: number): number =>
          vertex(at.map((x, k) => x + (k === axis ? side : k === u ? du : k === v ? dv : 0)));
        const ring = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
        faces.push(`f ${(side === 0 ? ring.reverse() : ring).join(' ')}`);
      }
  }
  return `${[...[...index.keys()].map((key) => `v ${key}`), ...faces].join('\n')}\n`;
}

/** A bumpy ball of `rings` × `around` vertices, all faces quads but for two caps. */
export function bumpyObj(rings: number, around: number): string {
  const lines: string[] = [];
  for (let i = 0; i < rings; i++)
    for (let j = 0; j < around; j++) {
      const [a, b] = [(Math.PI * (i + 0.5)) / rings, (2 * Math.PI * j) / around];
      const r = 1 + 0.12 * Math.sin(4 * a) * Math.cos(3 * b) + 0.05 * Math.cos(7 * a + 2 * b);
      const at = [r * Math.sin(a) * Math.cos(b), r * Math.cos(a), r * Math.sin(a) * Math.sin(b)];
      lines.push(`v ${at.map((x) => x.toFixed(5)).join(' ')}`);
    }
  const vertex = (i: number, j: number): number => i * around + (j % around) + 1;
  for (let i = 0; i + 1 < rings; i++)
    for (let j = 0; j < around; j++)
      lines.push(`f ${[vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1), vertex(i + 1, j)].join(' ')}`);
  const cap = (i: number): number[] => Array.from({ length: around }, (_, j) => vertex(i, j));
  lines.push(`f ${cap(0).reverse().join(' ')}`, `f ${cap(rings - 1).join(' ')}`);
  return `${lines.join('\n')}\n`;
}

/** A tube with caps that stands up, `around` × `along` vertices and two more: 2 wide, 20 high, wavy. */
export function tubeObj(around: number, along: number): string {
  const lines = ['v 0 0 0', 'v 0 20 0'];
  for (let j = 0; j < along; j++)
    for (let i = 0; i < around; i++) {
      const angle = (2 * Math.PI * i) / around;
      const r = 1 + 0.05 * Math.sin(9 * angle) * Math.sin(j / 9);
      const [x, y, z] = [r * Math.cos(angle), (20 * j) / (along - 1), r * Math.sin(angle)];
      lines.push(`v ${x.toFixed(5)} ${y.toFixed(5)} ${z.toFixed(5)}`);
    }
  const at = (i: number, j: number) => 3 + around * j + (i % around);
  for (let i = 0; i < around; i++) {
    lines.push(`f 1 ${at(i, 0)} ${at(i + 1, 0)}`, `f 2 ${at(i + 1, along - 1)} ${at(i, along - 1)}`);
    for (let j = 0; j + 1 < along; j++)
      lines.push(`f ${at(i, j)} ${at(i, j + 1)} ${at(i + 1, j + 1)} ${at(i + 1, j)}`);
  }
  return `${lines.join('\n')}\n`;
}
