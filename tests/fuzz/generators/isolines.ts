import { sheet } from '../../cli/shapes';
import { kernelGenerator } from '../kernel';
import { DEFORM } from '../recipes';

const options = {
  isolines: 6,
  basis: 'quadratic',
  local: 'patches',
  sampledTriangles: 60,
  scaleDetails: false,
  settle: 'full',
};

export default kernelGenerator({
  kind: 'isoline run',
  every: 20,
  recipe: { ...DEFORM, steps: DEFORM.steps.map((step) => ({ ...step, method: 'isolines', options })) },
  models: { m: sheet(8, 8) },
});
