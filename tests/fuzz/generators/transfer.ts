import { sheet } from '../../cli/shapes';
import { bar, type Shape } from '../../kernel/shapes';
import { kernelGenerator } from '../kernel';
import { TRANSFER } from '../recipes';

const named = (name: string, shape: Shape) => ({ name, ...shape });

export default kernelGenerator({
  kind: 'transfer run',
  every: 30,
  recipe: TRANSFER,
  models: { m: sheet(8, 8), t: named('t', bar(8, 3)) },
});
