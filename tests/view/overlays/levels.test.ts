import { expect, test } from 'vitest';
import { ModelView } from '../../../web/view/model-view';
import { LEVELS } from '../../../web/view/overlays/levels';
import { made } from '../card';

const view = () =>
  new ModelView({
    positions: Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0),
    triangles: Uint32Array.of(0, 1, 2),
    faceOffsets: Uint32Array.of(0, 3),
    faceVertices: Uint32Array.of(0, 1, 2),
    welded: Int32Array.of(0, 1, 2),
  });
const values = Float32Array.of(0, 0.5, 1);

test('lines are the surface’s own: there only while a field of that model is given', () => {
  const layer = made(LEVELS);
  expect(layer.shade).toBeUndefined();
  layer.setLevels({ values, steps: 20 });
  expect(layer.shade).toBeUndefined();
  const model = view();
  layer.place(model.space, model);
  layer.setLevels({ values, steps: 20 });
  expect(layer.shade?.uniforms.levelSteps?.value).toBe(20);
  expect([...model.geometry.getAttribute('level').array]).toEqual([...values]);
  layer.setLevels(null);
  expect(layer.shade).toBeUndefined();
  layer.setLevels({ values, steps: 20 });
  const other = view();
  layer.place(other.space, other);
  expect(layer.shade).toBeUndefined();
  layer.setLevels({ values, steps: 10 });
  layer.dispose();
  expect(other.geometry.hasAttribute('level')).toBe(false);
});
