import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import type { Model } from '../../web/core/model';
import { writeModel } from '../../web/io';
import { anyModel, facesOf, galleryFile, makeModel, models, read, uvOfCorners } from './support';

/** What every format with polygons must bring back. */
const core = (model: Model) => ({
  positions: model.positions,
  faces: facesOf(model),
  colors: model.colors,
  colorAlpha: model.colorAlpha,
  uvs: uvOfCorners(model),
});

describe.each(['obj', 'ply', 'ascii ply'] as const)('%s', (kind) => {
  const through = (model: Model) =>
    kind === 'ascii ply'
      ? read(writeModel(model, 'ply', { ascii: true }), 'a.ply')
      : read(writeModel(model, kind), `a.${kind}`);

  test('positions to the bit, polygons, colours and texture coordinates come back', () => {
    fc.assert(
      fc.property(anyModel, (model) => {
        expect(core(through(model))).toEqual(core(model));
      }),
    );
  });

  test('a second trip changes nothing more', () => {
    fc.assert(
      fc.property(anyModel, (model) => {
        const once = through(model);
        expect(through(once)).toEqual(once);
      }),
    );
  });

  test('coordinates that are no numbers, and corners without a vertex, come back', () => {
    const model = makeModel(
      [0, 0, 0, NaN, 1, -Infinity, 0, Infinity, -0],
      [
        [0, 1, 2],
        [0, 1, 0xffffffff],
        [0, 1, 99],
      ],
    );
    expect(core(through(model))).toEqual(core(model));
  });

  test('unit and up-axis come back', () => {
    const model: Model = {
      ...makeModel([0, 0, 0, 1, 0, 0, 0, 1, 0], [[0, 1, 2]]),
      unitMetres: 0.001,
      upAxis: 'z',
    };
    expect(through(model)).toMatchObject({ unitMetres: 0.001, upAxis: 'z' });
  });
});

test('the vertex sets of a PLY come back', () => {
  fc.assert(
    fc.property(anyModel, (model) => {
      expect(read(writeModel(model, 'ply')).vertexSets).toEqual(model.vertexSets);
    }),
  );
});

/** Positions of all triangle corners in order: what formats without shared vertices can keep. */
const cornerPositions = ({ positions, faceVertices }: Model): number[][] =>
  Array.from(faceVertices, (v) => [...positions.subarray(3 * v, 3 * v + 3)]);

const anyFloat = fc.float({ noNaN: true, noDefaultInfinity: true });
const nearFloat = fc.float({ min: -10, max: 10, noNaN: true });

test.each([true, false])('the facets of an STL come back (ascii: %s)', (ascii) => {
  fc.assert(
    fc.property(models(anyFloat, 3), (model) => {
      const again = read(writeModel(model, 'stl', { ascii }), 'a.stl');
      expect(cornerPositions(again)).toEqual(cornerPositions(model));
      expect(read(writeModel(again, 'stl'), 'a.stl')).toEqual(again);
    }),
  );
});

test.each(['glb', 'gltf'] as const)(
  'vertices keep their order and triangles their corners in a %s',
  (format) => {
    fc.assert(
      fc.property(models(nearFloat, 3), (model) => {
        const again = read(writeModel(model, format), `a.${format}`);
        const size = Math.max(...model.positions.map(Math.abs), 1e-30);
        const rows = Math.min(model.positions.length, again.positions.length);
        for (let i = 0; i < rows; i++)
          expect(Math.abs(again.positions[i]! - model.positions[i]!)).toBeLessThanOrEqual(1e-6 * size);
        expect(cornerPositions(again).length).toBe(cornerPositions(model).length);
        if (model.colors)
          expect([...again.colors!.subarray(0, model.colors.length)]).toEqual([...model.colors]);
        expect(again.colorAlpha).toBe(model.colorAlpha);
        if (!model.uvIndices) {
          expect(facesOf(again)).toEqual(facesOf(model));
          expect(again.vertexSets).toEqual(model.vertexSets);
        }
      }),
    );
  },
);

test('a head keeps its scalp, its order and its coordinates through every format', () => {
  const head = read(galleryFile('head-elf.ply'), 'head-elf.ply');
  for (const format of ['obj', 'ply', 'glb'] as const) {
    const again = read(writeModel(head, format), `a.${format}`);
    expect(again.faceVertices).toEqual(head.faceVertices);
    expect(again.positions).toEqual(head.positions);
  }
  const stl = read(writeModel(head, 'stl'), 'a.stl');
  expect(cornerPositions(stl)).toEqual(cornerPositions(head));
  expect(read(writeModel(head, 'ply')).vertexSets).toEqual(head.vertexSets);
  expect(read(writeModel(head, 'glb')).vertexSets).toEqual(head.vertexSets);
});
