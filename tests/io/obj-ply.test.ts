import { expect, test } from 'vitest';
import { readModel, writeModel } from '../../web/io/formats';

const bytes = (text: string) => new TextEncoder().encode(text);

test('an OBJ and its PLY hold the same model', () => {
  const { model } = readModel(bytes('v 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 1e-7\nf 1 2 3 4\n'), 'quad.obj');
  const again = readModel(writeModel(model, 'ply'), 'quad.ply').model;
  expect(again.positions).toEqual(model.positions);
  expect(again.faceVertices).toEqual(Uint32Array.of(0, 1, 2, 3));
});
