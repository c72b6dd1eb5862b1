import fc from 'fast-check';
import { expect, test } from 'vitest';
import { newHairStep } from '../../../web/recipe/steps/hair';
import { lengthFactors } from '../../../web/run/steps/hair';
import { type LengthHost, lengthMapOf, paintLength } from '../../../web/tools/hair/length-tool';
import { at, SIDE, Table } from '../table';

const ALL = SIDE * SIDE;

/** A sheet whose left half is a scalp, and a brush of one factor. */
function salon(factor: number) {
  const table = new Table();
  const seen = {
    factors: new Float32Array(ALL).fill(1) as Float32Array,
    factor,
    previews: [] as Float32Array[],
    said: [] as string[],
  };
  const host: LengthHost = {
    view: table.view,
    brush: table.brush,
    showPaint: (paint) => {
      if (!paint) seen.previews.length = 0;
    },
    lengthScene: () => ({
      graph: table.graph,
      mirrored: (vertices) => vertices.filter((v) => v % SIDE < 10),
      factors: seen.factors,
      factor: seen.factor,
    }),
    previewLengths: (factors) => seen.previews.push(factors),
    commitLengths: (verb, factors) => {
      seen.said.push(verb);
      seen.factors = factors;
    },
  };
  return { table, seen, tool: paintLength(host), factorAt: (x: number, y: number) => seen.factors[at(x, y)] };
}

test('a stroke gives its factor to the scalp under it, and to nothing beside', () => {
  const { table, seen, tool, factorAt } = salon(0.5);
  table.stroke(tool, [
    [4, 10],
    [16, 10],
  ]);
  expect([factorAt(4, 10), factorAt(9, 10), factorAt(10, 10), factorAt(4, 14)]).toEqual([0.5, 0.5, 1, 1]);
  expect(seen.said).toEqual(['paint']);
  seen.factor = 1.5;
  table.click(tool, 5, 10);
  expect([factorAt(5, 10), factorAt(8, 10)]).toEqual([1.5, 0.5]);
});

test('the hair follows the stroke; Escape leaves everything as it was', () => {
  const { table, seen, tool } = salon(0.5);
  tool.down(table.sample(4, 10));
  tool.move([table.sample(8, 10)]);
  expect(seen.previews).toHaveLength(2);
  expect(seen.previews[1]![at(8, 10)]).toBe(0.5);
  tool.cancel();
  expect(seen.previews).toEqual([]);
  expect(seen.said).toEqual([]);
});

test('Alt gives back the length of all, whatever was painted', () => {
  const { table, seen, tool, factorAt } = salon(0.5);
  table.click(tool, 4, 10);
  seen.factor = 1.5;
  table.click(tool, 7, 10);
  table.stroke(
    tool,
    [
      [4, 10],
      [7, 10],
    ],
    { alt: true },
  );
  expect([factorAt(4, 10), factorAt(7, 10)]).toEqual([1, 1]);
  expect(seen.said).toEqual(['paint', 'paint', 'erase']);
});

test('Shift and a click give the whole scalp one length', () => {
  const { table, tool, seen } = salon(0.25);
  table.click(tool, 3, 3, { shift: true });
  expect([...seen.factors].every((factor, v) => factor === (v % SIDE < 10 ? 0.25 : 1))).toBe(true);
});

test('factors come back out of the recipe as they went in', () => {
  const factor = fc.constantFrom(0, 0.05, 0.5, 1, 1.95, 2);
  fc.assert(
    fc.property(fc.array(factor, { minLength: 1, maxLength: 60 }), (all) => {
      const factors = Float32Array.from(all);
      const map = lengthMapOf(factors);
      expect(lengthFactors(map, all.length)).toEqual(factors);
      expect(map.map((part) => part.factor)).toEqual([...new Set(all)].filter((f) => f !== 1).sort());
    }),
    { seed: 5 },
  );
  expect(lengthMapOf(new Float32Array(9).fill(1))).toEqual(newHairStep('hair 1', 'head').length.map);
});
