import { fromIndices } from '../../core/vertex-set';
import type { HairStep } from '../../recipe/recipe';
import type { PaintHost, PaintScene } from '../brush-stroke';
import { PaintTool, type PaintVerb } from '../paint-tool';

type LengthMap = HairStep['length']['map'];

export interface LengthScene extends PaintScene {
  /** Factor of the length per source vertex; 1 where nothing is painted. */
  readonly factors: Float32Array;
  /** The factor that the brush paints. */
  readonly factor: number;
}

export interface LengthHost extends PaintHost {
  lengthScene(): LengthScene | null;
  /** Shows the hair of a stroke under way; `showPaint(null)` ends it. */
  previewLengths(factors: Float32Array): void;
  commitLengths(verb: PaintVerb, factors: Float32Array): void;
}

/** Paints how long hair grows where: the brush gives its factor, erasing gives back the length of all. */
export const paintLength = (host: LengthHost): PaintTool<LengthScene> =>
  new PaintTool(host, {
    kind: 'scalp',
    scene: () => host.lengthScene(),
    canvas: ({ factors, factor }, _, erase) => {
      const base = verticesWhere(factors, (held) => (erase ? held !== 1 : same(held, factor)));
      const painted = (vertices: Uint32Array): Float32Array => {
        const out = factors.slice();
        if (!erase) for (const v of vertices) out[v] = factor;
        const kept = new Set(vertices);
        for (const v of base) if (!kept.has(v)) out[v] = 1;
        return out;
      };
      return {
        base,
        preview: (vertices) => host.previewLengths(painted(vertices)),
        commit: (verb, vertices) => host.commitLengths(verb, painted(vertices)),
      };
    },
  });

/** Factors in few digits, as recipes keep them: each with its vertices, shortest first, 1 left out. */
export function lengthMapOf(factors: Float32Array): LengthMap {
  const byFactor = new Map<number, number[]>();
  factors.forEach((held, v) => {
    const factor = Number(held.toFixed(DIGITS));
    if (factor === 1) return;
    const vertices = byFactor.get(factor);
    if (vertices) vertices.push(v);
    else byFactor.set(factor, [v]);
  });
  return [...byFactor]
    .toSorted(([a], [b]) => a - b)
    .map(([factor, vertices]) => ({ vertices: fromIndices(vertices, factors.length), factor }));
}

const DIGITS = 3;

const same = (a: number, b: number): boolean => a.toFixed(DIGITS) === b.toFixed(DIGITS);

function verticesWhere(factors: Float32Array, is: (factor: number) => boolean): Uint32Array {
  const out: number[] = [];
  factors.forEach((factor, v) => {
    if (is(factor)) out.push(v);
  });
  return Uint32Array.from(out);
}
